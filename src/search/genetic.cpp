// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <shigusa/core/check.hpp>
#include <shigusa/search/genetic.hpp>
#include <shigusa/search/genetic_operators.hpp>
#include <utility>

namespace shigusa {
namespace {

void check(const DiscreteProblem& problem, const GeneticSettings& s) {
  SHG_CHECK(problem.evaluate != nullptr, "the problem has no evaluate function");
  SHG_CHECK(problem.genes >= 1 && problem.genes <= kMaxGenes,
            fmt::format("genes is {}, allowed: 1..{}", problem.genes, kMaxGenes));
  SHG_CHECK(
      problem.bits_per_gene >= 1 && problem.bits_per_gene <= kMaxBitsPerGene,
      fmt::format("bits_per_gene is {}, allowed: 1..{}", problem.bits_per_gene, kMaxBitsPerGene));
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

// Scores genomes through the problem, each distinct one once, and keeps the counts and the best.
class Scorer {
 public:
  Scorer(const DiscreteProblem& problem, SearchResult& result)
      : problem_(problem), result_(result) {}

  // How many genomes have been scored or are about to be.
  [[nodiscard]] int planned() const {
    return result_.evaluations + static_cast<int>(batch_.size());
  }

  // Adds what is new among these genomes to the next batch, if all of it keeps to the limit.
  bool plan(const std::vector<Genome>& genomes, std::optional<int> limit) {
    std::set<Genome> fresh;
    for (const Genome& genome : genomes) {
      if (!scores_.contains(genome)) fresh.insert(genome);
    }
    if (limit && planned() + static_cast<int>(fresh.size()) > *limit) return false;
    for (const Genome& genome : genomes) {
      const auto [entry, is_new] = scores_.try_emplace(genome, kWorst);
      if (is_new) batch_.push_back(entry);
    }
    return true;
  }

  void score_batch() {
    if (batch_.empty()) return;
    std::vector<std::uint16_t> packed;
    for (const auto& entry : batch_) {
      packed.insert(packed.end(), entry->first.begin(), entry->first.end());
    }
    std::vector<double> scores(batch_.size(), std::numeric_limits<double>::quiet_NaN());
    problem_.evaluate(packed, scores);
    for (std::size_t i = 0; i < batch_.size(); ++i) keep(*batch_[i], scores[i]);
    batch_.clear();
  }

  [[nodiscard]] Individual scored(const Genome& genome) const {
    return {genome, scores_.at(genome)};
  }

 private:
  void keep(std::pair<const Genome, double>& entry, double score) {
    const bool first = result_.evaluations++ == 0;
    if (std::isnan(score)) {
      ++result_.rejected_nan;
      score = kWorst;
    }
    entry.second = score;
    if (first || score < result_.best_seen.score) result_.best_seen = {entry.first, score};
  }

  static constexpr double kWorst = std::numeric_limits<double>::infinity();

  const DiscreteProblem& problem_;
  SearchResult& result_;
  std::map<Genome, double> scores_;
  std::vector<std::map<Genome, double>::iterator> batch_;
};

std::vector<Individual> next_population(std::vector<Individual> pool,
                                        const GeneticSettings& settings, Random& random) {
  std::vector<double> fitnesses;
  for (const Individual& individual : pool) {
    fitnesses.push_back(fitness(individual.score, settings.fitness_offset));
  }
  std::vector<Individual> selected;
  for (const int index : roulette(fitnesses, settings.population, random)) {
    selected.push_back(std::move(pool[static_cast<std::size_t>(index)]));
  }
  return selected;
}

// One run of the algorithm, a generation at a time, so that several runs are scored together.
class Run {
 public:
  Run(const DiscreteProblem& problem, const GeneticSettings& settings)
      : bits_(problem.bits_per_gene),
        settings_(settings),
        random_(settings.seed, settings.stream),
        test_(settings.unchanged_generations) {
    for (int i = 0; i < settings.population; ++i) {
      wanted_.push_back(random_genome(problem.genes, bits_, random_));
    }
  }

  // The genomes that the next step needs the scores of; meaningless once it has ended.
  [[nodiscard]] const std::vector<Genome>& wanted() const { return wanted_; }
  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] bool converged() const { return converged_; }
  [[nodiscard]] int generations() const { return generations_; }
  [[nodiscard]] std::vector<Individual>& population() { return population_; }

  void end() { ended_ = true; }

  // The initial population, or the next one from the one before and its offspring.
  void step(const Scorer& scorer) {
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
  std::vector<Individual> population_;
  std::vector<Genome> wanted_;
  int generations_ = 0;
  bool converged_ = false;
  bool ended_ = false;
};

// Runs side by side, all their new genomes scored together, generation by generation.
class Runs {
 public:
  Runs(const DiscreteProblem& problem, const GeneticSettings& settings)
      : problem_(problem),
        settings_(settings),
        limit_(settings.max_evaluations),
        scorer_(problem, result_) {}

  void start() {
    GeneticSettings settings = settings_;
    settings.stream += runs_.size();
    runs_.emplace_back(problem_, settings);
  }

  // Starts runs up to so many at once, as far as the limit lets all have their initial population.
  void refill(int at_once) {
    int wanted = result_.evaluations;
    int going = 0;
    for (const Run& run : runs_) {
      if (run.ended()) continue;
      ++going;
      wanted += static_cast<int>(run.wanted().size());
    }
    for (; going < at_once && wanted + settings_.population <= *limit_; ++going) {
      start();
      wanted += settings_.population;
    }
  }

  [[nodiscard]] bool going() const {
    return std::any_of(runs_.begin(), runs_.end(), [](const Run& run) { return !run.ended(); });
  }

  // One step of each run that goes on; what exceeds the limit ends instead.
  void step() {
    std::vector<Run*> stepping;
    for (Run& run : runs_) {
      if (run.ended()) continue;
      if (scorer_.plan(run.wanted(), limit_)) {
        stepping.push_back(&run);
      } else {
        run.end();
      }
    }
    scorer_.score_batch();
    result_.generations = 0;
    for (Run* run : stepping) run->step(scorer_);
    for (const Run& run : runs_) result_.generations += run.generations();
  }

  [[nodiscard]] const SearchResult& so_far() const { return result_; }
  [[nodiscard]] const Run& first() const { return runs_.front(); }

  SearchResult finish(SearchEnd end) {
    result_.end = end;
    for (Run& run : runs_) {
      std::vector<Individual>& population = run.population();
      result_.final_population.insert(result_.final_population.end(),
                                      std::make_move_iterator(population.begin()),
                                      std::make_move_iterator(population.end()));
    }
    return std::move(result_);
  }

 private:
  const DiscreteProblem& problem_;
  GeneticSettings settings_;
  std::optional<int> limit_;
  SearchResult result_;
  Scorer scorer_;
  std::vector<Run> runs_;  // by stream
};

void report(const Progress& progress, const SearchResult& result, double fraction) {
  if (!progress.report) return;
  progress.report({"search", fraction, result.evaluations, result.best_seen.score});
}

}  // namespace

SearchResult genetic_search(const DiscreteProblem& problem, const GeneticSettings& settings,
                            const Progress& progress) {
  check(problem, settings);
  Runs runs(problem, settings);
  runs.start();
  while (runs.going()) {
    const bool began = runs.so_far().evaluations > 0;
    if (began && progress.cancelled()) return runs.finish(SearchEnd::cancelled);
    const int before = runs.first().generations();
    runs.step();
    const int now = runs.first().generations();
    // nothing to tell where the limit did not let it step
    if (began && now == before) break;
    report(
        progress, runs.so_far(),
        settings.max_generations == 0 ? 1.0 : static_cast<double>(now) / settings.max_generations);
  }
  const bool converged = runs.first().converged();
  return runs.finish(converged ? SearchEnd::converged : SearchEnd::budget);
}

SearchResult restarted_genetic_search(const DiscreteProblem& problem,
                                      const GeneticSettings& settings, int evaluations,
                                      const Progress& progress) {
  GeneticSettings limited = settings;
  limited.max_evaluations = evaluations;
  check(problem, limited);
  const int at_once = std::clamp(evaluations / kEvaluationsPerRun, 1, kRunsAtOnce);
  Runs runs(problem, limited);
  for (runs.refill(at_once); runs.going(); runs.refill(at_once)) {
    if (runs.so_far().evaluations > 0 && progress.cancelled()) break;
    runs.step();
    report(progress, runs.so_far(), static_cast<double>(runs.so_far().evaluations) / evaluations);
  }
  return runs.finish(progress.cancelled() ? SearchEnd::cancelled : SearchEnd::budget);
}

}  // namespace shigusa
