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

  // True when scoring these genomes would keep to the limit.
  [[nodiscard]] bool affords(const std::vector<Genome>& genomes, std::optional<int> limit) const {
    if (!limit) return true;
    std::set<Genome> fresh;
    for (const Genome& genome : genomes) {
      if (!scores_.contains(genome)) fresh.insert(genome);
    }
    return result_.evaluations + static_cast<int>(fresh.size()) <= *limit;
  }

  std::vector<Individual> scored(std::vector<Genome> genomes) {
    evaluate_new(genomes);
    std::vector<Individual> individuals;
    for (Genome& genome : genomes) {
      const double score = scores_.at(genome);
      individuals.push_back({std::move(genome), score});
    }
    return individuals;
  }

 private:
  void evaluate_new(const std::vector<Genome>& genomes) {
    std::vector<std::map<Genome, double>::iterator> batch;
    std::vector<std::uint16_t> packed;
    for (const Genome& genome : genomes) {
      const auto [entry, is_new] = scores_.try_emplace(genome, kWorst);
      if (!is_new) continue;
      batch.push_back(entry);
      packed.insert(packed.end(), genome.begin(), genome.end());
    }
    if (batch.empty()) return;
    std::vector<double> scores(batch.size(), std::numeric_limits<double>::quiet_NaN());
    problem_.evaluate(packed, scores);
    for (std::size_t i = 0; i < batch.size(); ++i) keep(*batch[i], scores[i]);
  }

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
};

void append(std::vector<Individual>& pool, std::vector<Individual> more) {
  pool.insert(pool.end(), std::make_move_iterator(more.begin()),
              std::make_move_iterator(more.end()));
}

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

void report(const Progress& progress, const SearchResult& result, int max_generations) {
  if (!progress.report) return;
  const double fraction =
      max_generations == 0 ? 1.0 : static_cast<double>(result.generations) / max_generations;
  progress.report({"search", fraction, result.evaluations, result.best_seen.score});
}

}  // namespace

SearchResult genetic_search(const DiscreteProblem& problem, const GeneticSettings& settings,
                            const Progress& progress) {
  check(problem, settings);
  SearchResult result;
  Scorer scorer(problem, result);
  Random random(settings.seed, settings.stream);

  // generation 0
  std::vector<Genome> initial;
  for (int i = 0; i < settings.population; ++i) {
    initial.push_back(random_genome(problem.genes, problem.bits_per_gene, random));
  }
  std::vector<Individual> population = scorer.scored(std::move(initial));
  ConvergenceTest test(settings.unchanged_generations);
  bool converged = test.converged(population);
  report(progress, result, settings.max_generations);

  while (!converged && result.generations < settings.max_generations) {
    if (progress.cancelled()) {
      result.end = SearchEnd::cancelled;
      break;
    }
    std::vector<Genome> offspring =
        children_of(population, settings.crossover_rate, problem.bits_per_gene, random);
    for (Genome& mutant :
         mutants_of(population, settings.mutation_rate, problem.bits_per_gene, random)) {
      offspring.push_back(std::move(mutant));
    }
    if (!scorer.affords(offspring, settings.max_evaluations)) break;
    std::vector<Individual> pool = std::move(population);
    append(pool, scorer.scored(std::move(offspring)));
    population = next_population(std::move(pool), settings, random);
    ++result.generations;
    converged = test.converged(population);
    report(progress, result, settings.max_generations);
  }
  if (converged) result.end = SearchEnd::converged;
  result.final_population = std::move(population);
  return result;
}

SearchResult restarted_genetic_search(const DiscreteProblem& problem,
                                      const GeneticSettings& settings, int evaluations,
                                      const Progress& progress) {
  SearchResult all;
  Progress overall = progress;
  if (progress.report) {
    overall.report = [&](const ProgressReport& run) {
      ProgressReport sum = run;
      sum.evaluations += all.evaluations;
      sum.fraction = static_cast<double>(sum.evaluations) / evaluations;
      const bool first = all.evaluations == 0;
      sum.best_score = first ? run.best_score : std::min(run.best_score, all.best_seen.score);
      progress.report(sum);
    };
  }
  GeneticSettings run_settings = settings;
  do {
    run_settings.max_evaluations = evaluations - all.evaluations;
    SearchResult run = genetic_search(problem, run_settings, overall);
    const bool first = all.evaluations == 0;
    if (first || run.best_seen.score < all.best_seen.score) all.best_seen = run.best_seen;
    append(all.final_population, std::move(run.final_population));
    all.evaluations += run.evaluations;
    all.rejected_nan += run.rejected_nan;
    all.generations += run.generations;
    ++run_settings.stream;
  } while (evaluations - all.evaluations >= settings.population && !progress.cancelled());
  all.end = progress.cancelled() ? SearchEnd::cancelled : SearchEnd::budget;
  return all;
}

}  // namespace shigusa
