// SPDX-License-Identifier: MIT
#include "search/normal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/statistics.hpp"
#include "search/population.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

TEST(Normal, FallsIntoIntervalsAsOftenAsTheDistributionFunctionSays) {
  Random random(1);
  constexpr int draws = 200000;
  // 32 intervals from -4 to 4, and the tails
  std::vector<int> counts(34);
  for (int i = 0; i < draws; ++i) {
    const double place = std::floor((normal(random) + 4.0) * 4.0) + 1.0;
    ++counts.at(static_cast<std::size_t>(std::clamp(place, 0.0, 33.0)));
  }
  const auto below = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
  std::vector<double> probabilities{below(-4.0)};
  for (int i = 0; i < 32; ++i)
    probabilities.push_back(below(i * 0.25 - 3.75) - below(i * 0.25 - 4));
  probabilities.push_back(below(-4.0));
  EXPECT_LT(chi_square(counts, probabilities), chi_square_limit(33));
}

TEST(Normal, HasTheMomentsOfItsTails) {
  Random random(2);
  constexpr int draws = 400000;
  double squares = 0.0;
  double fourth = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double x = normal(random);
    squares += x * x / draws;
    fourth += x * x * x * x / draws;
  }
  // the variances of x² and x⁴ are 2 and 105 - 9
  EXPECT_NEAR(squares, 1.0, 5.0 * std::sqrt(2.0 / draws));
  EXPECT_NEAR(fourth, 3.0, 5.0 * std::sqrt(96.0 / draws));
}

TEST(Normal, SuccessiveNumbersAreIndependent) {
  Random random(3);
  constexpr int draws = 200000;
  double last = normal(random);
  double product = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double x = normal(random);
    product += x * last / draws;
    last = x;
  }
  EXPECT_NEAR(product, 0.0, 5.0 / std::sqrt(static_cast<double>(draws)));
}

TEST(Reflected, MirrorsAtBothFaces) {
  EXPECT_EQ(reflected(0.25), 0.25);
  EXPECT_EQ(reflected(0.0), 0.0);
  EXPECT_EQ(reflected(1.0), 1.0);
  EXPECT_EQ(reflected(-0.25), 0.25);
  EXPECT_EQ(reflected(1.25), 0.75);
  EXPECT_EQ(reflected(2.25), 0.25);
  EXPECT_EQ(reflected(-1.25), 0.75);
  EXPECT_EQ(reflected(-2.25), 0.25);
  for (const double x : {1e16, -1e300, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(reflected(x) >= 0.0 && reflected(x) <= 1.0);
  }
}

TEST(KeepBest, KeepsTheLowestInOrderAndEarlierOnesAmongEquals) {
  std::vector<Individual> best;
  keep_best(best, std::vector<double>{0.1, 0.2, 0.3}, std::vector<double>{3.0, 1.0, 2.0}, 3);
  keep_best(best, std::vector<double>{0.4, 0.5}, std::vector<double>{2.0, 0.5}, 3);
  ASSERT_EQ(best.size(), 3U);
  EXPECT_EQ(best[0], (Individual{{0.5}, 0.5}));
  EXPECT_EQ(best[1], (Individual{{0.2}, 1.0}));
  EXPECT_EQ(best[2], (Individual{{0.3}, 2.0}));
}

}  // namespace
}  // namespace shigusa
