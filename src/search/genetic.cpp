// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <shigusa/core/check.hpp>
#include <shigusa/search/genetic.hpp>
#include <shigusa/search/genetic_operators.hpp>
#include <utility>

#include "scorer.hpp"

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

// Scores genomes, each distinct one once.
class GenomeScorer {
 public:
  GenomeScorer(Scorer& scorer, int bits_per_gene) : scorer_(scorer), bits_(bits_per_gene) {}

  // Adds what is new among these genomes to the next batch.
  void plan(const std::vector<Genome>& genomes) {
    for (const Genome& genome : genomes) {
      const auto [entry, is_new] = scores_.try_emplace(genome, kWorst);
      if (is_new) batch_.push_back(entry);
    }
  }

  // Forgets what the budget did not suffice for.
  void score_batch() {
    std::vector<double> points;
    for (const auto& entry : batch_) {
      const std::vector<double> point = point_of_genome(entry->first, bits_);
      points.insert(points.end(), point.begin(), point.end());
    }
    std::vector<double> scores(batch_.size());
    const auto scored = static_cast<std::size_t>(scorer_.score(points, scores));
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      if (i < scored) {
        batch_[i]->second = scores[i];
      } else {
        scores_.erase(batch_[i]);
      }
    }
    batch_.clear();
  }

  [[nodiscard]] bool all_scored(const std::vector<Genome>& genomes) const {
    return std::all_of(genomes.begin(), genomes.end(),
                       [&](const Genome& genome) { return scores_.contains(genome); });
  }

  [[nodiscard]] ScoredGenome scored(const Genome& genome) const {
    return {genome, scores_.at(genome)};
  }

 private:
  Scorer& scorer_;
  int bits_;
  std::map<Genome, double> scores_;
  std::vector<std::map<Genome, double>::iterator> batch_;
};

std::vector<ScoredGenome> next_population(std::vector<ScoredGenome> pool,
                                          const GeneticSettings& settings, Random& random) {
  std::vector<double> fitnesses;
  for (const ScoredGenome& individual : pool) {
    fitnesses.push_back(fitness(individual.score, settings.fitness_offset));
  }
  std::vector<ScoredGenome> selected;
  for (const int index : roulette(fitnesses, settings.population, random)) {
    selected.push_back(std::move(pool[static_cast<std::size_t>(index)]));
  }
  return selected;
}

// One run of the algorithm, a generation at a time, so that several runs are scored together.
class Run {
 public:
  Run(int genes, const GeneticSettings& settings)
      : bits_(settings.bits_per_gene),
        settings_(settings),
        random_(settings.seed, settings.stream),
        test_(settings.unchanged_generations) {
    for (int i = 0; i < settings.population; ++i) {
      wanted_.push_back(random_genome(genes, bits_, random_));
    }
  }

  // The genomes that the next step needs the scores of; meaningless once it has ended.
  [[nodiscard]] const std::vector<Genome>& wanted() const { return wanted_; }
  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] bool converged() const { return converged_; }
  [[nodiscard]] int generations() const { return generations_; }
  [[nodiscard]] const std::vector<ScoredGenome>& population() const { return population_; }

  // The initial population, or the next one from the one before and its offspring.
  void step(const GenomeScorer& scorer) {
    const bool initial = population_.empty();
    for (const Genome& genome : wanted_) population_.push_back(scorer.scored(genome));
    if (!initial) {
      population_ = next_population(std::move(population_), settings_, random_);
      ++generations_;
    }
    converged_ = test_.converged(population_);
    ended_ = converged_ || generations_ == settings_.max_generations;
    if (!ended_) want_offspring();
  }

 private:
  void want_offspring() {
    wanted_ = children_of(population_, settings_.crossover_rate, bits_, random_);
    for (Genome& mutant : mutants_of(population_, settings_.mutation_rate, bits_, random_)) {
      wanted_.push_back(std::move(mutant));
    }
  }

  int bits_;
  GeneticSettings settings_;
  Random random_;
  ConvergenceTest test_;
  std::vector<ScoredGenome> population_;
  std::vector<Genome> wanted_;
  int generations_ = 0;
  bool converged_ = false;
  bool ended_ = false;
};

// Runs side by side, all their new genomes scored together, generation by generation.
class Runs {
 public:
  Runs(Scorer& scorer, const GeneticSettings& settings)
      : scorer_(scorer), settings_(settings), genomes_(scorer, settings.bits_per_gene) {}

  void start() {
    GeneticSettings settings = settings_;
    settings.stream += runs_.size();
    going_.push_back(runs_.size());
    runs_.emplace_back(scorer_.genes(), settings);
  }

  // Starts runs while there is budget, as many at once as the number of those that have ended says.
  // It must not depend on the budget: what is scored first would.
  void refill() {
    const std::size_t ended = runs_.size() - going_.size();
    std::size_t at_once = kRunsAtFirst;
    while (2 * at_once <= std::min<std::size_t>(ended, kRunsAtOnce)) at_once *= 2;
    while (going_.size() < at_once && scorer_.left() > 0 && !exhausted()) start();
  }

  [[nodiscard]] bool going() const { return !going_.empty(); }
  [[nodiscard]] bool exhausted() const {
    return runs_.size() >= runs_when_new_ + kRunsWithoutNew + kRunsAtOnce;
  }

  // One step of each run that goes on; those that the budget does not suffice for end instead.
  void step() {
    for (const std::size_t r : going_) genomes_.plan(runs_[r].wanted());
    const int before = scorer_.left();
    genomes_.score_batch();
    if (scorer_.left() < before) runs_when_new_ = runs_.size();
    std::vector<std::size_t> still_going;
    for (const std::size_t r : going_) {
      if (!genomes_.all_scored(runs_[r].wanted())) continue;
      const int generations = runs_[r].generations();
      runs_[r].step(genomes_);
      scorer_.result().generations += runs_[r].generations() - generations;
      if (!runs_[r].ended()) still_going.push_back(r);
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
            {point_of_genome(individual.genes, settings_.bits_per_gene), individual.score});
      }
    }
    return std::move(result);
  }

 private:
  Scorer& scorer_;
  GeneticSettings settings_;
  GenomeScorer genomes_;
  std::vector<Run> runs_;           // by stream
  std::vector<std::size_t> going_;  // which of them have not ended
  std::size_t runs_when_new_ = 0;   // how many there were when a genome was last new
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
    runs.step();
    // nothing to tell where the limit did not let it step
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
    runs.step();
    scorer.report(static_cast<double>(so_far.evaluations) / evaluations);
  }
  return runs.finish(scorer.left() > 0 ? SearchEnd::converged : SearchEnd::budget);
}

}  // namespace shigusa
