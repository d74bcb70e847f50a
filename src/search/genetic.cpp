// SPDX-License-Identifier: MIT
#include "search/genetic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <shigusa/search.hpp>
#include <utility>

#include "core/check.hpp"
#include "core/hash.hpp"
#include "scorer.hpp"
#include "search/genetic_operators.hpp"

namespace shigusa {
namespace {

void check(const GeneticSettings& s) {
  SHG_CHECK(s.bits_per_gene >= 1 && s.bits_per_gene <= kMaxBitsPerGene,
            fmt::format("bits_per_gene is {}, allowed: 1..{}", s.bits_per_gene, kMaxBitsPerGene));
  SHG_CHECK(s.population >= 2 && s.population <= 1000 && s.population % 2 == 0,
            fmt::format("population is {}, allowed: even, 2..1000", s.population));
  SHG_CHECK(s.crossover_rate >= 0.0 && s.crossover_rate <= 1.0,
            fmt::format("crossover_rate is {}, allowed: 0..1", s.crossover_rate));
  SHG_CHECK(s.mutation_rate >= 0.0 && s.mutation_rate <= 1.0,
            fmt::format("mutation_rate is {}, allowed: 0..1", s.mutation_rate));
  SHG_CHECK(s.max_generations >= 0,
            fmt::format("max_generations is {}, allowed: 0 and more", s.max_generations));
  SHG_CHECK(
      s.unchanged_generations >= 1,
      fmt::format("unchanged_generations is {}, allowed: 1 and more", s.unchanged_generations));
  SHG_CHECK(!s.max_evaluations || *s.max_evaluations >= s.population,
            fmt::format("max_evaluations is {}, allowed: {} (the population) and more",
                        s.max_evaluations.value_or(0), s.population));
  SHG_CHECK(s.fitness_offset >= 1e-12 && s.fitness_offset <= 1e12,
            fmt::format("fitness_offset is {}, allowed: 1e-12..1e12", s.fitness_offset));
}

// A genome ordered by its hash, which mostly decides without comparing the genes.
struct HashedGenome {
  std::uint64_t hash = 0;
  Genome genes;

  explicit HashedGenome(Genome genome) : genes(std::move(genome)) {
    Fnv1a mixed;
    for (const std::uint16_t gene : genes) mixed.mix(gene);
    hash = mixed.value();
  }
  friend bool operator<(const HashedGenome& a, const HashedGenome& b) {
    return a.hash != b.hash ? a.hash < b.hash : a.genes < b.genes;
  }
};

// Scores genomes, each distinct one once.
class GenomeScorer {
 public:
  GenomeScorer(Scorer& scorer, int bits_per_gene) : scorer_(scorer), bits_(bits_per_gene) {}

  // A genome and its score, once scored; its address is stable.
  using Entry = std::pair<const HashedGenome, std::optional<double>>;

  // Queues the new ones among these genomes; returns the entries of all.
  std::vector<const Entry*> plan(std::vector<Genome> genomes) {
    std::vector<const Entry*> entries;
    entries.reserve(genomes.size());
    for (Genome& genome : genomes) {
      const auto [entry, is_new] =
          scores_.try_emplace(HashedGenome(std::move(genome)), std::nullopt);
      if (is_new) queue_.push_back(&*entry);
      entries.push_back(&*entry);
    }
    return entries;
  }

  [[nodiscard]] std::size_t queued() const { return queue_.size(); }

  // Scores the first genomes of the queue, as many as fill batches of `size`; all if there are
  // fewer. Genomes beyond the budget stay without a score.
  void score_batches_of(std::size_t size) {
    const std::size_t count =
        queue_.size() < size ? queue_.size() : queue_.size() - queue_.size() % size;
    points_.clear();
    for (std::size_t i = 0; i < count; ++i) append_point(queue_[i]->first.genes, bits_, points_);
    scores_of_batch_.resize(count);
    const auto scored = static_cast<std::size_t>(scorer_.score(points_, scores_of_batch_));
    for (std::size_t i = 0; i < scored; ++i) queue_[i]->second = scores_of_batch_[i];
    queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(count));
  }

 private:
  Scorer& scorer_;
  int bits_;
  std::map<HashedGenome, std::optional<double>> scores_;
  std::vector<Entry*> queue_;
  std::vector<double> points_;           // (batch × genes)
  std::vector<double> scores_of_batch_;  // (batch)
};

std::vector<ScoredGenome> next_population(std::span<const ScoredGenome> pool,
                                          const GeneticSettings& settings, Random& random) {
  std::vector<double> fitnesses;
  fitnesses.reserve(pool.size());
  for (const ScoredGenome& individual : pool) {
    fitnesses.push_back(fitness(individual.score, settings.fitness_offset));
  }
  std::vector<ScoredGenome> selected;
  selected.reserve(pool.size());
  for (const int index : roulette(fitnesses, settings.population, random)) {
    selected.push_back(pool[static_cast<std::size_t>(index)]);
  }
  return selected;
}

// One run of the algorithm, a generation at a time, so that several runs are scored together.
class Run {
 public:
  Run(int genes, const GeneticSettings& settings, GenomeScorer& genomes)
      : bits_(settings.bits_per_gene),
        settings_(settings),
        random_(settings.seed, settings.stream),
        test_(settings.unchanged_generations) {
    std::vector<Genome> initial;
    for (int i = 0; i < settings.population; ++i) {
      initial.push_back(random_genome(genes, bits_, random_));
    }
    wanted_ = genomes.plan(std::move(initial));
  }

  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] bool converged() const { return converged_; }
  [[nodiscard]] int generations() const { return generations_; }
  [[nodiscard]] const std::vector<ScoredGenome>& population() const { return population_; }

  // Whether all genomes for the next step are scored.
  [[nodiscard]] bool ready() const {
    return std::all_of(wanted_.begin(), wanted_.end(),
                       [](const auto* entry) { return entry->second.has_value(); });
  }

  // Forms the initial population, or the next one from the last and its offspring.
  void step(GenomeScorer& genomes) {
    const bool initial = population_.empty();
    for (const auto* entry : wanted_)
      population_.push_back({&entry->first.genes, entry->second.value()});
    if (!initial) {
      population_ = next_population(population_, settings_, random_);
      ++generations_;
    }
    converged_ = test_.converged(population_);
    ended_ = converged_ || generations_ == settings_.max_generations;
    if (!ended_) wanted_ = genomes.plan(offspring());
  }

 private:
  std::vector<Genome> offspring() {
    std::vector<Genome> all = children_of(population_, settings_.crossover_rate, bits_, random_);
    for (Genome& mutant : mutants_of(population_, settings_.mutation_rate, bits_, random_)) {
      all.push_back(std::move(mutant));
    }
    return all;
  }

  int bits_;
  GeneticSettings settings_;
  Random random_;
  ConvergenceTest test_;
  std::vector<ScoredGenome> population_;
  std::vector<const GenomeScorer::Entry*> wanted_;
  int generations_ = 0;
  bool converged_ = false;
  bool ended_ = false;
};

// Parallel runs whose new genomes are scored together.
class Runs {
 public:
  Runs(Scorer& scorer, const GeneticSettings& settings)
      : scorer_(scorer), settings_(settings), genomes_(scorer, settings.bits_per_gene) {}

  void start() {
    GeneticSettings settings = settings_;
    settings.stream += runs_.size();
    going_.push_back(runs_.size());
    runs_.emplace_back(scorer_.genes(), settings, genomes_);
  }

  // Starts runs while there is budget, up to the number for the runs that have ended, and more if a
  // batch would not be full. The number must not depend on the budget, as the order of scoring
  // would.
  void refill() {
    const std::size_t ended = runs_.size() - going_.size();
    std::size_t at_once = kRunsAtFirst;
    while (2 * at_once <= std::min<std::size_t>(ended, kRunsAtOnce)) at_once *= 2;
    const auto fewer = [&] { return going_.size() < at_once || genomes_.queued() < kFullBatch; };
    while (fewer() && scorer_.left() > 0 && !exhausted()) start();
  }

  [[nodiscard]] bool going() const { return !going_.empty(); }
  [[nodiscard]] bool exhausted() const {
    return runs_.size() >= runs_when_new_ + kRunsWithoutNew + kRunsAtOnce;
  }

  // Scores queued genomes, in full batches of `size` where they fill one; runs with all genomes
  // scored go one step, the others wait, or end once the budget is used up.
  void step(std::size_t size) {
    const int before = scorer_.left();
    genomes_.score_batches_of(size);
    if (scorer_.left() < before) runs_when_new_ = runs_.size();
    std::vector<std::size_t> still_going;
    for (const std::size_t r : going_) {
      Run& run = runs_[r];
      if (run.ready()) {
        const int generations = run.generations();
        run.step(genomes_);
        scorer_.result().generations += run.generations() - generations;
        if (run.ended()) continue;
      } else if (scorer_.left() == 0) {
        continue;
      }
      still_going.push_back(r);
    }
    going_ = std::move(still_going);
  }

  [[nodiscard]] const Run& first() const { return runs_.front(); }

  SearchResult finish(SearchEnd end) {
    SearchResult& result = scorer_.result();
    result.end = end;
    for (const Run& run : runs_) {
      for (const ScoredGenome& individual : run.population()) {
        result.final_population.push_back(
            {point_of_genome(*individual.genes, settings_.bits_per_gene), individual.score});
      }
    }
    return std::move(result);
  }

 private:
  Scorer& scorer_;
  GeneticSettings settings_;
  GenomeScorer genomes_;
  std::vector<Run> runs_;           // by stream
  std::vector<std::size_t> going_;  // indices of the unfinished ones
  std::size_t runs_when_new_ = 0;   // number of runs at the last new genome
};

}  // namespace

SearchResult genetic_search(const SearchProblem& problem, const GeneticSettings& settings,
                            const Progress& progress) {
  check(settings);
  Scorer scorer(problem, settings.max_evaluations.value_or(std::numeric_limits<int>::max()),
                progress);
  Runs runs(scorer, settings);
  runs.start();
  for (int now = -1; runs.going();) {
    if (now >= 0 && progress.cancelled()) return runs.finish(SearchEnd::cancelled);
    runs.step(1);
    // no progress to report if the limit prevented the step
    if (now == runs.first().generations()) break;
    now = runs.first().generations();
    const int all = settings.max_generations;
    scorer.report(all == 0 ? 1.0 : static_cast<double>(now) / all);
  }
  const bool converged = runs.first().converged();
  return runs.finish(converged ? SearchEnd::converged : SearchEnd::budget);
}

SearchResult restarted_genetic_search(const SearchProblem& problem, const GeneticSettings& settings,
                                      int evaluations, const Progress& progress) {
  GeneticSettings limited = settings;
  limited.max_evaluations = evaluations;
  check(limited);
  Scorer scorer(problem, evaluations, progress);
  Runs runs(scorer, limited);
  for (runs.refill(); runs.going(); runs.refill()) {
    const SearchResult& so_far = scorer.result();
    if (so_far.evaluations > 0 && progress.cancelled()) return runs.finish(SearchEnd::cancelled);
    runs.step(kFullBatch);
    scorer.report(static_cast<double>(so_far.evaluations) / evaluations);
  }
  return runs.finish(scorer.left() > 0 ? SearchEnd::converged : SearchEnd::budget);
}

SearchResult genetic_by_default(const SearchProblem& problem, int evaluations, std::uint64_t seed,
                                const Progress& progress) {
  GeneticSettings settings;
  settings.seed = seed;
  return restarted_genetic_search(problem, settings, evaluations, progress);
}

}  // namespace shigusa
