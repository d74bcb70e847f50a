// SPDX-License-Identifier: MIT
#include "search/random_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/statistics.hpp"
#include "search/test_functions.hpp"
#include "support/refusal.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;

TEST(RandomSearch, PointsAreUniform) {
  Record record;
  (void)random_search(record.watch(problem_of(2, sphere)), {.evaluations = 20000});
  std::vector<int> counts(64);
  for (const std::vector<double>& point : record.points) {
    ++counts.at(static_cast<std::size_t>(8.0 * point[0]) * 8 +
                static_cast<std::size_t>(8.0 * point[1]));
  }
  EXPECT_LT(chi_square_uniform(counts), chi_square_limit(63));
}

TEST(RandomSearch, BestIsAsGoodAsChanceHasIt) {
  // the share of the square within r of the optimum is π r²: the best of N has a score r² whose
  // median is ln 2 / (π N)
  const double median = median_best(2, sphere, [](const SearchProblem& problem, auto seed) {
    return random_search(problem, {.evaluations = 1000, .seed = seed});
  });
  const double expected = std::log(2.0) / (kPi * 1000.0);
  EXPECT_GT(median, expected / 3.0);
  EXPECT_LT(median, expected * 3.0);
}

TEST(RandomSearch, BatchesChangeNoPoint) {
  Record small;
  Record large;
  (void)random_search(small.watch(problem_of(3, sphere)), {.batch = 1, .evaluations = 100});
  (void)random_search(large.watch(problem_of(3, sphere)), {.batch = 64, .evaluations = 100});
  EXPECT_EQ(small.points, large.points);
  EXPECT_THAT(large.batches, ::testing::ElementsAre(64U, 36U));
}

TEST(RandomSearch, FinalPopulationIsTheBestInOrder) {
  Record record;
  const SearchResult result =
      random_search(record.watch(problem_of(3, sphere)), {.keep = 10, .evaluations = 200});
  std::vector<double> scores = record.scores;
  std::sort(scores.begin(), scores.end());
  ASSERT_EQ(result.final_population.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(result.final_population[i].score, scores[i]);
}

TEST(RandomSearch, RefusesSettingsOutOfRangeAndNamesThem) {
  const auto told = [](const RandomSettings& settings) {
    return refusal([&] { return random_search(problem_of(3, sphere), settings); });
  };
  for (const int number : {-1, 0, 10001}) {
    EXPECT_THAT(told({.batch = number}), HasSubstr("batch is"));
    EXPECT_THAT(told({.keep = number}), HasSubstr("keep is"));
  }
}

}  // namespace
}  // namespace shigusa
