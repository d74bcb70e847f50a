// SPDX-License-Identifier: MIT
#include "search/annealing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "search/test_functions.hpp"
#include "support/refusal.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;

double best_after(int evaluations, int genes, const Function& function) {
  return median_best(genes, function, [&](const SearchProblem& problem, auto seed) {
    return annealing_search(problem, {.evaluations = evaluations, .seed = seed});
  });
}

TEST(Annealing, ComesNearTheOptimumOfTheSphere) {
  // the last moves are 0.003 wide; n of them squared are 4.5e-5 and 9e-5
  EXPECT_LT(best_after(10000, 5, sphere), 4.5e-5);
  EXPECT_LT(best_after(10000, 10, sphere), 9e-5);
}

TEST(Annealing, LeavesLocalMinima) {
  // a descent ends about 5 minima off in each coordinate; 1 is one coordinate in the next minimum
  EXPECT_LT(best_after(30000, 5, rastrigin), 1.0);
  EXPECT_LT(best_after(30000, 2, rastrigin), 0.1);
}

TEST(Annealing, LeavesLocalMinimaOnlyWhileItIsWarm) {
  // Two wells of depths 1 and 0 with a hill of 4.5 between; from the floor of the shallow one it
  // takes a move of six deviations to get lower at once, so a cold chain stays where it began.
  const Function wells = [](std::span<const double> x) {
    const double shallow = 1.0 + 100.0 * (x[0] - 0.3) * (x[0] - 0.3);
    const double deep = 100.0 * (x[0] - 0.7) * (x[0] - 0.7);
    return std::min(shallow, deep);
  };
  constexpr int chains = 8;
  constexpr int seeds = 20;
  const auto deep_chains = [&](double hot) {
    int count = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const SearchResult result =
          annealing_search(problem_of(1, wells), {.evaluations = chains * 1001,
                                                  .chains = chains,
                                                  .first_cycle = 1000,
                                                  .first_step = 0.05,
                                                  .last_step = 0.05,
                                                  .hot = hot,
                                                  .cooling = 1e-2,
                                                  .seed = seed});
      for (const Individual& chain : result.final_population) count += chain.score < 0.5 ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(deep_chains(1.0), chains * seeds * 8 / 10);
  EXPECT_LT(deep_chains(1e-6), chains * seeds * 7 / 10);
}

TEST(Annealing, FinalPopulationIsTheBestOfEachChain) {
  Record record;
  const SearchResult result = annealing_search(record.watch(problem_of(3, sphere)),
                                               {.evaluations = 16 + 16 * 32, .seed = 2});
  ASSERT_EQ(result.final_population.size(), 16U);
  // until the first cycle has ended chains know nothing of each other: point i is of chain i mod
  // 16, and the lowest score of a chain is always taken
  for (std::size_t chain = 0; chain < 16; ++chain) {
    double best = record.scores[chain];
    for (std::size_t i = chain; i < record.scores.size(); i += 16) {
      best = std::min(best, record.scores[i]);
    }
    EXPECT_EQ(result.final_population[chain].score, best);
  }
}

TEST(Annealing, MovesAllChainsInOneCall) {
  Record record;
  (void)annealing_search(record.watch(problem_of(9, sphere)), {.evaluations = 170});
  for (std::size_t b = 0; b + 1 < record.batches.size(); ++b) EXPECT_EQ(record.batches[b], 16U);
}

TEST(Annealing, RefusesSettingsOutOfRangeAndNamesThem) {
  const auto told = [](const AnnealingSettings& settings) {
    return refusal([&] { return annealing_search(problem_of(3, sphere), settings); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int chains : {-1, 1, 10001}) {
    EXPECT_THAT(told({.chains = chains}), HasSubstr("chains is"));
  }
  for (const int steps : {0, 1000001}) {
    EXPECT_THAT(told({.first_cycle = steps}), HasSubstr("first_cycle is"));
  }
  for (const double step : {0.0, 1.1, nan}) {
    EXPECT_THAT(told({.first_step = step}), HasSubstr("first_step is"));
  }
  for (const double step : {0.0, 0.31, nan}) {
    EXPECT_THAT(told({.last_step = step}), HasSubstr("last_step is"));
  }
  for (const double hot : {0.0, -1.0, nan}) {
    EXPECT_THAT(told({.hot = hot}), HasSubstr("hot is"));
  }
  for (const double cooling : {0.0, 1.1, nan}) {
    EXPECT_THAT(told({.cooling = cooling}), HasSubstr("cooling is"));
  }
}

}  // namespace
}  // namespace shigusa
