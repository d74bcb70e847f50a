// SPDX-License-Identifier: MIT
#include "simd/pack.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <shigusa/run.hpp>

#include "simd/lane_counts.hpp"

namespace shigusa {
namespace {

using testing_support::LaneCount;
using testing_support::LaneCounts;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
// numbers of every size, and those that arithmetic most easily gets wrong
constexpr float kSpecial[] = {0.0F,   -0.0F, 1.0F,   -1.0F,     1e-45F,     -1e-45F,
                              1e-38F, 3e38F, -3e38F, kInfinity, -kInfinity, kNaN};

float any_float(Random& random) {
  if (random.chance(0.3)) return kSpecial[random.below(std::size(kSpecial))];
  const double size = std::ldexp(random.uniform(0.5, 1.0), static_cast<int>(random.below(60)) - 30);
  return static_cast<float>(random.chance(0.5) ? size : -size);
}

template <int N>
Pack<float, N> any_pack(Random& random) {
  Pack<float, N> pack;
  for (int lane = 0; lane < N; ++lane) pack.set(lane, any_float(random));
  return pack;
}

// the same bits, or both NaN: which of two NaNs an operation passes on is unspecified
testing::AssertionResult same(float a, float b) {
  if ((std::isnan(a) && std::isnan(b)) ||
      std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b)) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << a << " is not " << b;
}

template <class Count>
class PackOf : public testing::Test {};
TYPED_TEST_SUITE(PackOf, LaneCounts, );

TYPED_TEST(PackOf, ComputesInEachLaneAsAFloatDoes) {
  constexpr int N = TypeParam::value;
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const Pack<float, N> a = any_pack<N>(random);
    const Pack<float, N> b = any_pack<N>(random);
    for (int lane = 0; lane < N; ++lane) {
      const float x = a[lane];
      const float y = b[lane];
      ASSERT_TRUE(same((a + b)[lane], x + y));
      ASSERT_TRUE(same((a - b)[lane], x - y));
      ASSERT_TRUE(same((a * b)[lane], x * y));
      ASSERT_TRUE(same((a / b)[lane], x / y));
      ASSERT_TRUE(same((-a)[lane], -x));
      ASSERT_TRUE(same(abs(a)[lane], std::fabs(x)));
      ASSERT_TRUE(same(sqrt(a)[lane], std::sqrt(x)));
    }
  }
}

TYPED_TEST(PackOf, ComparesInEachLaneAsAFloatDoes) {
  constexpr int N = TypeParam::value;
  Random random(2);
  for (int trial = 0; trial < 2000; ++trial) {
    const Pack<float, N> a = any_pack<N>(random);
    const Pack<float, N> b = any_pack<N>(random);
    for (int lane = 0; lane < N; ++lane) {
      ASSERT_EQ((a < b)[lane], a[lane] < b[lane]);
      ASSERT_EQ((a > b)[lane], a[lane] > b[lane]);
      ASSERT_EQ((a <= b)[lane], a[lane] <= b[lane]);
      ASSERT_EQ((a >= b)[lane], a[lane] >= b[lane]);
    }
  }
}

TYPED_TEST(PackOf, SelectsMinAndMaxInEachLaneAsForDouble) {
  // NaN and signed zeros included: min and max give the first argument unless the second is beyond
  constexpr int N = TypeParam::value;
  Random random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    const Pack<float, N> a = any_pack<N>(random);
    const Pack<float, N> b = any_pack<N>(random);
    const Pack<float, N> c = any_pack<N>(random);
    for (int lane = 0; lane < N; ++lane) {
      const auto x = static_cast<double>(a[lane]);
      const auto y = static_cast<double>(b[lane]);
      ASSERT_TRUE(same(min(a, b)[lane], static_cast<float>(min(x, y))));
      ASSERT_TRUE(same(max(a, b)[lane], static_cast<float>(max(x, y))));
      ASSERT_TRUE(same(select(c < a, a, b)[lane], c[lane] < a[lane] ? a[lane] : b[lane]));
    }
  }
}

TYPED_TEST(PackOf, MasksCombineLaneByLane) {
  constexpr int N = TypeParam::value;
  Random random(4);
  for (int trial = 0; trial < 500; ++trial) {
    const auto a = any_pack<N>(random) < any_pack<N>(random);
    const auto b = any_pack<N>(random) < any_pack<N>(random);
    for (int lane = 0; lane < N; ++lane) {
      ASSERT_EQ((a & b)[lane], a[lane] && b[lane]);
      ASSERT_EQ((a | b)[lane], a[lane] || b[lane]);
      ASSERT_EQ((!a)[lane], !a[lane]);
    }
  }
}

TYPED_TEST(PackOf, AnyAndAllLookAtEveryLane) {
  constexpr int N = TypeParam::value;
  const Pack<float, N> zero(0.0F);
  EXPECT_FALSE(any(zero > zero));
  EXPECT_TRUE(all(zero >= zero));
  for (int lane = 0; lane < N; ++lane) {
    Pack<float, N> one_lane(0.0F);
    one_lane.set(lane, 1.0F);
    EXPECT_TRUE(any(one_lane > zero)) << lane;
    EXPECT_FALSE(all(one_lane <= zero)) << lane;
    EXPECT_EQ(all(one_lane > zero), N == 1) << lane;
  }
}

TYPED_TEST(PackOf, OneNumberFillsAllLanesRoundedToFloat) {
  constexpr int N = TypeParam::value;
  for (int lane = 0; lane < N; ++lane) {
    EXPECT_EQ((Pack<float, N>(0.1)[lane]), 0.1F);
    EXPECT_EQ((Pack<float, N>(0.25F)[lane]), 0.25F);
    EXPECT_EQ((Pack<float, N>(7)[lane]), 7.0F);
    EXPECT_EQ((Pack<float, N>()[lane]), 0.0F);
  }
}

TEST(Pack, IsMadeOfFloats) {
  EXPECT_TRUE((std::is_same_v<Element<Pack<float, 8>>, float>));
  EXPECT_TRUE((std::is_same_v<Element<double>, double>));
  EXPECT_EQ((ScalarTraits<Pack<float, 8>>::kLanes), 8);
  EXPECT_EQ(ScalarTraits<double>::kLanes, 1);
}

TEST(Pack, MinAndMaxOfEqualZerosOrNaNAreTheFirstArgument) {
  const Pack<float, 4> zero(0.0F);
  const Pack<float, 4> negative_zero(-0.0F);
  const Pack<float, 4> nan(kNaN);
  EXPECT_FALSE(std::signbit(min(zero, negative_zero)[0]));
  EXPECT_TRUE(std::signbit(min(negative_zero, zero)[0]));
  EXPECT_FALSE(std::signbit(max(zero, negative_zero)[0]));
  EXPECT_TRUE(std::signbit(max(negative_zero, zero)[0]));
  EXPECT_EQ(min(zero, nan)[0], 0.0F);
  EXPECT_EQ(max(zero, nan)[0], 0.0F);
  EXPECT_TRUE(std::isnan(min(nan, zero)[0]));
  EXPECT_TRUE(std::isnan(max(nan, zero)[0]));
}

}  // namespace
}  // namespace shigusa
