// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <shigusa/core/check.hpp>
#include <shigusa/search/genetic.hpp>
#include <vector>

namespace shigusa {
namespace {

// The sum of six genes; counts what it scores.
DiscreteProblem sum_of_genes(int& scored) {
  DiscreteProblem problem;
  problem.genes = 6;
  problem.evaluate = [&scored](std::span<const std::uint16_t> genomes, std::span<double> scores) {
    scored += static_cast<int>(scores.size());
    for (std::size_t i = 0; i < scores.size(); ++i) {
      scores[i] = 0.0;
      for (std::size_t g = 0; g < 6; ++g) scores[i] += genomes[i * 6 + g] / 90.0;
    }
  };
  return problem;
}

TEST(MaxEvaluations, AreNeverExceeded) {
  for (int limit = kPaperPopulation; limit < 60; ++limit) {
    int scored = 0;
    GeneticSettings settings;
    settings.max_evaluations = limit;
    const SearchResult result = genetic_search(sum_of_genes(scored), settings);
    EXPECT_LE(scored, limit);
    EXPECT_EQ(scored, result.evaluations);
  }
}

TEST(MaxEvaluations, BelowThePopulationAreRefused) {
  int scored = 0;
  GeneticSettings settings;
  settings.max_evaluations = kPaperPopulation - 1;
  EXPECT_THROW((void)genetic_search(sum_of_genes(scored), settings), PreconditionError);
}

TEST(MaxEvaluations, ThatAreEnoughChangeNothing) {
  int scored = 0;
  GeneticSettings settings;
  const SearchResult free = genetic_search(sum_of_genes(scored), settings);
  settings.max_evaluations = 100'000;
  const SearchResult limited = genetic_search(sum_of_genes(scored), settings);
  EXPECT_EQ(free.final_population, limited.final_population);
}

TEST(RestartedGeneticSearch, UsesItsBudgetUpToLessThanAPopulation) {
  for (const int budget : {8, 100, 1000, 1007}) {
    int scored = 0;
    const SearchResult result = restarted_genetic_search(sum_of_genes(scored), {}, budget);
    EXPECT_LE(scored, budget);
    EXPECT_GT(scored, budget - kPaperPopulation);
    EXPECT_EQ(scored, result.evaluations);
    EXPECT_EQ(result.end, SearchEnd::budget);
  }
}

TEST(RestartedGeneticSearch, BeginsWithTheSingleRunOfTheSeed) {
  int scored = 0;
  const SearchResult once = genetic_search(sum_of_genes(scored), {});
  const SearchResult often = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  const auto begin = often.final_population.begin();
  EXPECT_TRUE(std::equal(once.final_population.begin(), once.final_population.end(), begin));
}

TEST(RestartedGeneticSearch, GathersTheFinalPopulationsOfAllRuns) {
  int scored = 0;
  const SearchResult result = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  EXPECT_GT(result.final_population.size(), 5U * kPaperPopulation);
  EXPECT_EQ(result.final_population.size() % kPaperPopulation, 0U);
}

TEST(RestartedGeneticSearch, RunsDiffer) {
  int scored = 0;
  const SearchResult result = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  std::set<std::vector<std::uint16_t>> genomes;
  for (const Individual& individual : result.final_population) genomes.insert(individual.genes);
  EXPECT_GT(genomes.size(), result.final_population.size() / 2);
}

TEST(RestartedGeneticSearch, BestSeenIsTheBestOfAllRuns) {
  int scored = 0;
  const SearchResult result = restarted_genetic_search(sum_of_genes(scored), {}, 1000);
  for (const Individual& individual : result.final_population) {
    EXPECT_LE(result.best_seen.score, individual.score);
  }
}

TEST(RestartedGeneticSearch, ReportsGrowingShareOfTheBudget) {
  int scored = 0;
  Progress progress;
  double fraction = 0.0;
  double best = 1e9;
  progress.report = [&](const ProgressReport& report) {
    EXPECT_GE(report.fraction, fraction);
    EXPECT_LE(report.fraction, 1.0);
    EXPECT_LE(report.best_score, best);
    fraction = report.fraction;
    best = report.best_score;
  };
  (void)restarted_genetic_search(sum_of_genes(scored), {}, 1000, progress);
  EXPECT_GT(fraction, 0.9);
}

TEST(RestartedGeneticSearch, CancelledEndsWithTheBestSoFar) {
  int scored = 0;
  std::atomic<bool> cancel{false};
  Progress progress;
  progress.cancel = &cancel;
  progress.report = [&](const ProgressReport& report) { cancel = report.evaluations > 200; };
  const SearchResult result =
      restarted_genetic_search(sum_of_genes(scored), {}, 1'000'000, progress);
  EXPECT_EQ(result.end, SearchEnd::cancelled);
  EXPECT_LT(result.evaluations, 300);
  EXPECT_FALSE(result.best_seen.genes.empty());
}

}  // namespace
}  // namespace shigusa
