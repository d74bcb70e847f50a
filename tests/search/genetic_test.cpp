// SPDX-License-Identifier: MIT
#include "search/genetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>

#include "core/statistics.hpp"
#include "search/genome_problem.hpp"
#include "support/refusal.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Mean over genes of ((gene - target) / 15)², target (5 g + 3) mod 16: separable, 0 at its only
// optimum.
double separable(const Genome& genome) {
  double sum = 0.0;
  for (std::size_t g = 0; g < genome.size(); ++g) {
    const double gap =
        (static_cast<double>(genome[g]) - static_cast<double>((5 * g + 3) % 16)) / 15;
    sum += gap * gap;
  }
  return sum / static_cast<double>(genome.size());
}

const SearchProblem kSeparable = problem_of(8, 4, separable);

TEST(GeneticSearch, FinalPopulationHasTheSizeAndTheScoresOfItsGenomes) {
  const SearchResult result = genetic_search(kSeparable, {.population = 12, .seed = 1});
  EXPECT_EQ(result.final_population.size(), 12U);
  for (const Individual& individual : result.final_population) {
    EXPECT_EQ(individual.score, separable(genome_of(individual)));
  }
}

TEST(GeneticSearch, InitialPopulationIsUniform) {
  std::vector<int> counts(16);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    GenomeRecorder recorder;
    (void)genetic_search(recorder.watch(kSeparable), {.max_generations = 0, .seed = seed});
    for (const Genome& genome : recorder.all()) {
      for (const auto gene : genome) ++counts.at(gene);
    }
  }
  EXPECT_LT(chi_square_uniform(counts), chi_square_limit(15));
}

TEST(GeneticSearch, EachGenomeIsScoredOnce) {
  // 64 genomes in all: most children have been seen before
  const SearchProblem tiny = problem_of(3, 2, separable);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    GenomeRecorder recorder;
    const SearchResult result = genetic_search(
        recorder.watch(tiny, 2),
        {.bits_per_gene = 2, .population = 20, .max_generations = 100, .seed = seed});
    const std::vector<Genome> all = recorder.all();
    EXPECT_EQ(std::set<Genome>(all.begin(), all.end()).size(), all.size());
    EXPECT_EQ(result.evaluations, static_cast<int>(all.size()));
    for (const Individual& individual : result.final_population) {
      EXPECT_EQ(individual.score, separable(genome_of(individual, 2)));
    }
  }
}

TEST(GeneticSearch, EachGenerationIsOneNonEmptyBatchAtMost) {
  GenomeRecorder recorder;
  const SearchResult result =
      genetic_search(recorder.watch(kSeparable), {.unchanged_generations = 100, .seed = 3});
  EXPECT_LE(recorder.batches.size(), 1U + static_cast<std::size_t>(result.generations));
  for (const auto& batch : recorder.batches) EXPECT_FALSE(batch.empty());
  EXPECT_EQ(recorder.batches[0].size(), 8U);
}

TEST(GeneticSearch, OneGenerationScoresAsManyAsExpected) {
  // 4 pairs · 0.5 · 2 children and 8 · 0.1 mutants. A child equals its first parent if the parents
  // agree after the cut: (1/2 + 1/4 + …) / 31 of the cuts, and as often its second. The number has
  // a variance of 4 · 4 · 0.25 + 8 · 0.09 = 4.72, or less.
  int total = 0;
  constexpr int searches = 4000;
  for (std::uint64_t seed = 0; seed < searches; ++seed) {
    total += genetic_search(kSeparable, {.max_generations = 1, .seed = seed}).evaluations;
  }
  const double mean = static_cast<double>(total) / searches;
  EXPECT_NEAR(mean, 8.0 + 4.0 * (1.0 - 2.0 / 31.0) + 0.8, 5.0 * std::sqrt(4.72 / searches));
}

TEST(GeneticSearch, PopulationWithoutOffspringConvergesAfterThreeGenerations) {
  const SearchResult result =
      genetic_search(kSeparable, {.crossover_rate = 0.0, .mutation_rate = 0.0, .seed = 4});
  EXPECT_EQ(result.end, SearchEnd::converged);
  EXPECT_EQ(result.generations, 3);
  EXPECT_EQ(result.evaluations, 8);
}

TEST(GeneticSearch, StopsAtTheGenerationCap) {
  for (const int cap : {0, 1, 7}) {
    const SearchResult result =
        genetic_search(kSeparable, {.max_generations = cap, .unchanged_generations = 100});
    EXPECT_EQ(result.end, SearchEnd::budget);
    EXPECT_EQ(result.generations, cap);
  }
}

TEST(GeneticSearch, FindsTheOptimumOfASeparableProblemWithALargerBudget) {
  // the share of the 32 bits that are wrong: among 2^32 genomes one is right
  const auto wrong_bits = [](const Genome& genome) {
    int wrong = 0;
    for (std::size_t g = 0; g < genome.size(); ++g) {
      wrong += __builtin_popcount(static_cast<unsigned>(genome[g] ^ ((5 * g + 3) % 16)));
    }
    return wrong / 32.0;
  };
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const SearchResult result =
        genetic_search(problem_of(8, 4, wrong_bits), {.population = 100,
                                                      .mutation_rate = 0.5,
                                                      .max_generations = 200,
                                                      .unchanged_generations = 200,
                                                      .fitness_offset = 1e-3,
                                                      .seed = seed});
    EXPECT_EQ(result.best_seen.score, 0.0) << seed;
    EXPECT_LT(result.evaluations, 30000) << seed;
  }
}

TEST(GeneticSearch, TheBestCanBeLostAsThereIsNoElitism) {
  // One gene of one bit with scores 0 and 0.05, fitness 20 and 10. Two parents that both mutate
  // make a pool of two zeros and two ones, whatever they were; both draws are ones with
  // probability 20/60 · 10/50 = 1/15.
  const SearchProblem bit = problem_of(1, 1, [](const Genome& genome) { return 0.05 * genome[0]; });
  constexpr int searches = 15000;
  int lost = 0;
  for (std::uint64_t seed = 0; seed < searches; ++seed) {
    const SearchResult result = genetic_search(bit, {.bits_per_gene = 1,
                                                     .population = 2,
                                                     .mutation_rate = 1.0,
                                                     .max_generations = 1,
                                                     .seed = seed});
    EXPECT_EQ(result.best_seen.score, 0.0);
    const auto& last = result.final_population;
    lost += last[0].score > 0.0 && last[1].score > 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(lost, searches / 15.0, binomial_tolerance(searches, 1.0 / 15.0));
}

TEST(GeneticSearch, ThePoolHoldsParentsChildrenAndMutants) {
  // All scores equal: of a pool of 8 parents, 8 children and 8 mutants, a third of the draws each.
  // Parents are recognised by their scores in the first batch.
  constexpr int searches = 1000;
  int parents_kept = 0;
  int offspring = 0;
  for (std::uint64_t seed = 0; seed < searches; ++seed) {
    GenomeRecorder recorder;
    const SearchProblem flat = recorder.watch(problem_of(8, 4, [](const Genome&) { return 0.5; }));
    const SearchResult result = genetic_search(
        flat, {.crossover_rate = 1.0, .mutation_rate = 1.0, .max_generations = 1, .seed = seed});
    const auto& first = recorder.batches[0];
    for (const Individual& individual : result.final_population) {
      const bool kept = std::find(first.begin(), first.end(), genome_of(individual)) != first.end();
      (kept ? parents_kept : offspring) += 1;
    }
    ASSERT_LE(recorder.batches[1].size(), 16U);
  }
  // 2/31 of the children equal a parent (see above), which are 1/46 of the pool
  const double n = searches * 8.0;
  EXPECT_GT(parents_kept, n / 3.0 - binomial_tolerance(n, 1.0 / 3.0));
  EXPECT_LT(parents_kept, n * (1.0 / 3.0 + 1.0 / 46.0) + binomial_tolerance(n, 1.0 / 3.0));
}

TEST(GeneticSearch, NaNIsNotDrawnWhileOthersAreLeft) {
  const SearchProblem holes =
      problem_of(1, 4, [](const Genome& genome) { return genome[0] == 7 ? 0.5 : kNaN; });
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    GenomeRecorder recorder;
    const SearchResult result =
        genetic_search(recorder.watch(holes), {.max_generations = 1, .seed = seed});
    const auto& first = recorder.batches[0];
    if (std::find(first.begin(), first.end(), Genome{7}) == first.end()) continue;
    EXPECT_EQ(genome_of(result.final_population[0]), Genome{7});
  }
}

TEST(GeneticSearch, ReportsTheInitialPopulationAndEachGeneration) {
  std::vector<ProgressReport> reports;
  const SearchResult result =
      genetic_search(kSeparable, {.unchanged_generations = 100, .seed = 9},
                     {.report = [&](const ProgressReport& r) { reports.push_back(r); }});
  ASSERT_EQ(reports.size(), 21U);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    EXPECT_EQ(reports[i].fraction, static_cast<double>(i) / 20.0);
    if (i == 0) continue;
    EXPECT_GE(reports[i].evaluations, reports[i - 1].evaluations);
    EXPECT_LE(reports[i].best_score, reports[i - 1].best_score);
  }
  EXPECT_EQ(reports.front().evaluations, 8);
  EXPECT_EQ(reports.back().evaluations, result.evaluations);
  EXPECT_EQ(reports.back().best_score, result.best_seen.score);
}

TEST(GeneticSearch, CancelledDuringABatchFinishesThatGeneration) {
  std::atomic<bool> cancel = false;
  int calls = 0;
  SearchProblem problem = kSeparable;
  problem.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    kSeparable.evaluate(points, scores);
    if (++calls == 3) cancel = true;
  };
  // all pairs have children, so that each generation has a batch
  const SearchResult result = genetic_search(problem, {.crossover_rate = 1.0, .seed = 11},
                                             {.report = {}, .cancel = &cancel});
  EXPECT_EQ(result.end, SearchEnd::cancelled);
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(result.generations, 2);
  EXPECT_EQ(separable(genome_of(result.best_seen)), result.best_seen.score);
}

TEST(GeneticSearch, CancelledDuringTheLastGenerationIsDone) {
  std::atomic<bool> cancel = false;
  const auto report = [&](const ProgressReport& r) { cancel = r.fraction == 1.0; };
  const SearchResult result =
      genetic_search(kSeparable, {.max_generations = 2}, {.report = report, .cancel = &cancel});
  EXPECT_EQ(result.end, SearchEnd::budget);
  EXPECT_EQ(result.generations, 2);
}

TEST(GeneticSearch, WorksAtTheSmallestAndLargestSizes) {
  const auto count_of = [](int genes, int bits, int population) {
    return genetic_search(problem_of(genes, bits, separable),
                          {.bits_per_gene = bits, .population = population, .max_generations = 3})
        .evaluations;
  };
  EXPECT_GE(count_of(1, 1, 2), 1);
  EXPECT_GE(count_of(kMaxGenes, kMaxBitsPerGene, 2), 2);
  EXPECT_GE(count_of(1, 1, 1000), 2);
}

TEST(GeneticSearch, RefusesSettingsOutOfRangeAndNamesThem) {
  const auto told = [](const GeneticSettings& settings) {
    return refusal([&] { return genetic_search(kSeparable, settings); });
  };
  for (const int population : {-2, 0, 1, 7, 1001, 1002}) {
    EXPECT_EQ(told({.population = population})
                  .find("population is " + std::to_string(population) + ", allowed: even, 2..1000"),
              0U);
  }
  for (const double rate : {-0.01, 1.01, kNaN, kInfinity}) {
    EXPECT_EQ(told({.crossover_rate = rate}).find("crossover_rate is"), 0U);
    EXPECT_EQ(told({.mutation_rate = rate}).find("mutation_rate is"), 0U);
  }
  EXPECT_EQ(told({.max_generations = -1}).find("max_generations is -1"), 0U);
  EXPECT_EQ(told({.unchanged_generations = 0}).find("unchanged_generations is 0"), 0U);
  for (const int bits : {-1, 0, kMaxBitsPerGene + 1}) {
    EXPECT_EQ(told({.bits_per_gene = bits}).find("bits_per_gene is"), 0U);
  }
  for (const double offset : {0.0, -0.05, kNaN, kInfinity}) {
    EXPECT_EQ(told({.fitness_offset = offset}).find("fitness_offset is"), 0U);
  }
}

}  // namespace
}  // namespace shigusa
