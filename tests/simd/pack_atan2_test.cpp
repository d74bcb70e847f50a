// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <shigusa/run.hpp>
#include <vector>

#include "simd/lane_counts.hpp"
#include "simd/pack.hpp"

// The reference is the C library in long double.
namespace shigusa {
namespace {

using testing_support::LaneCounts;

float of_one(float y, float x) { return atan2(Pack<float, 1>(y), Pack<float, 1>(x))[0]; }

// The bound that pack.hpp states: a few units of single precision near π, 2.4e-7 each.
constexpr double kBound = 4e-7;

TEST(PackAtan2, ErrorIsBelowTheBoundAllAround) {
  Random random(1);
  long double largest = 0.0L;
  for (int i = 0; i < 500000; ++i) {
    const double angle = random.uniform(-kPi, kPi);
    const double length = exponential(random.uniform(-20.0, 20.0));
    const auto y = static_cast<float>(length * std::sin(angle));
    const auto x = static_cast<float>(length * std::cos(angle));
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    largest = std::fmax(largest, std::fabs(static_cast<long double>(of_one(y, x)) - exact));
  }
  EXPECT_LT(static_cast<double>(largest), kBound);
}

TEST(PackAtan2, KnowsTheAxes) {
  const auto half_turn = static_cast<float>(kPi);
  EXPECT_EQ(of_one(0.0F, 1.0F), 0.0F);
  EXPECT_EQ(of_one(0.0F, 0.0F), 0.0F);
  EXPECT_EQ(of_one(0.0F, -1.0F), half_turn);
  EXPECT_EQ(of_one(2.0F, 0.0F), half_turn / 2.0F);
  EXPECT_EQ(of_one(-2.0F, 0.0F), -half_turn / 2.0F);
}

TEST(PackAtan2, PassesNaNOn) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(std::isnan(of_one(nan, 1.0F)));
  EXPECT_TRUE(std::isnan(of_one(1.0F, nan)));
}

template <class Count>
class PackAtan2Of : public testing::Test {};
TYPED_TEST_SUITE(PackAtan2Of, LaneCounts, );

TYPED_TEST(PackAtan2Of, EachLaneHasTheBitsOfALaneAlone) {
  constexpr int N = TypeParam::value;
  Random random(2);
  for (int i = 0; i < 16000; i += N) {
    Pack<float, N> y;
    Pack<float, N> x;
    for (int lane = 0; lane < N; ++lane) {
      y.set(lane, static_cast<float>(random.uniform(-1.0, 1.0)));
      x.set(lane, static_cast<float>(random.uniform(-1.0, 1.0)));
    }
    const auto together = atan2(y, x);
    for (int lane = 0; lane < N; ++lane) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(together[lane]),
                std::bit_cast<std::uint32_t>(of_one(y[lane], x[lane])));
    }
  }
}

}  // namespace
}  // namespace shigusa
