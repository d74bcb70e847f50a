// SPDX-License-Identifier: MIT
#include "search/differential_evolution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "search/test_functions.hpp"
#include "support/refusal.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;

double best_after(int evaluations, int genes, const Function& function) {
  return median_best(genes, function, [&](const SearchProblem& problem, auto seed) {
    return differential_evolution_search(problem, {.evaluations = evaluations, .seed = seed});
  });
}

TEST(DifferentialEvolution, SolvesTheSphere) {
  EXPECT_LT(best_after(3000, 5, sphere), 1e-9);
  EXPECT_LT(best_after(5000, 10, sphere), 1e-9);
}

TEST(DifferentialEvolution, SolvesRastriginsFunction) {
  EXPECT_LT(best_after(12000, 5, rastrigin), 1e-9);
  EXPECT_LT(best_after(30000, 10, rastrigin), 1e-9);
}

TEST(DifferentialEvolution, SolvesRosenbrocksValleyInFewDimensions) {
  EXPECT_LT(best_after(20000, 5, rosenbrock), 1e-9);
}

TEST(DifferentialEvolution, ReachesOptimaOnFacesAndNearCorners) {
  EXPECT_LT(best_after(5000, 5, bowl_beyond), 1e-9);
  EXPECT_LT(best_after(5000, 5, corner), 1e-9);
}

TEST(DifferentialEvolution, NeverLosesTheBestOfItsPopulation) {
  const SearchResult result =
      differential_evolution_search(problem_of(5, rastrigin), {.evaluations = 2000});
  ASSERT_EQ(result.final_population.size(), 32U);
  double best = result.final_population[0].score;
  for (const Individual& individual : result.final_population) {
    best = std::min(best, individual.score);
  }
  EXPECT_EQ(best, result.best_seen.score);
}

TEST(DifferentialEvolution, BeginsAgainWhenItHasConverged) {
  // all equal: each population has converged at once, so that each batch is a new random one
  Record record;
  const SearchResult result = differential_evolution_search(
      record.watch(problem_of(3, [](std::span<const double>) { return 1.0; })),
      {.evaluations = 320, .population = 32});
  EXPECT_EQ(result.generations, 0);
  EXPECT_EQ(std::set<std::vector<double>>(record.points.begin(), record.points.end()).size(), 320U);
}

TEST(DifferentialEvolution, ScoresAGenerationInOneCall) {
  Record record;
  (void)differential_evolution_search(record.watch(problem_of(9, sphere)),
                                      {.evaluations = 330, .population = 32});
  for (std::size_t b = 0; b + 1 < record.batches.size(); ++b) EXPECT_EQ(record.batches[b], 32U);
  EXPECT_EQ(record.batches.back(), 10U);
}

TEST(DifferentialEvolution, RefusesSettingsOutOfRangeAndNamesThem) {
  const auto told = [](const DifferentialEvolutionSettings& settings) {
    return refusal([&] { return differential_evolution_search(problem_of(3, sphere), settings); });
  };
  for (const int population : {-1, 3, 10001}) {
    EXPECT_THAT(told({.population = population}), HasSubstr("population is"));
  }
  for (const double precision : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(told({.precision = precision}), HasSubstr("precision is"));
  }
  EXPECT_EQ(told({.population = 4}), "accepted");
}

}  // namespace
}  // namespace shigusa
