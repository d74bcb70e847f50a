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

// The largest error of sine or cosine over all angles that `next` gives.
template <class Next>
double largest_error(int count, Next&& next) {
  long double largest = 0.0L;
  for (int i = 0; i < count; i += 4) {
    Pack<float, 4> angles;
    for (int lane = 0; lane < 4; ++lane) angles.set(lane, static_cast<float>(next()));
    const SinCos<Pack<float, 4>> a = sin_cos(angles);
    for (int lane = 0; lane < 4; ++lane) {
      const auto exact = static_cast<long double>(angles[lane]);
      const auto sine = static_cast<long double>(a.sin[lane]);
      const auto cosine = static_cast<long double>(a.cos[lane]);
      largest = std::fmax(largest, std::fabs(sine - std::sin(exact)));
      largest = std::fmax(largest, std::fabs(cosine - std::cos(exact)));
    }
  }
  return static_cast<double>(largest);
}

// The bound that pack.hpp states. Rounding in single precision: 1 - z/2 and the last sum each half
// a unit of 6e-8, and what the reduction to [-π/4, π/4] loses.
constexpr double kBound = 1.2e-7;

TEST(PackSinCos, ErrorIsBelowTheBoundOnADenseGridUpToAHundred) {
  int i = 0;
  const double error = largest_error(1000004, [&] { return (i++ - 500002) * 2e-4; });
  RecordProperty("largest_error", std::to_string(error * 1e9) + "e-9");
  EXPECT_LT(error, kBound);
}

TEST(PackSinCos, ErrorIsBelowTheBoundOverRandomAnglesUpToAHundred) {
  Random random(1);
  EXPECT_LT(largest_error(500000, [&] { return random.uniform(-100.0, 100.0); }), kBound);
}

TEST(PackSinCos, ErrorIsBelowTheBoundWhereTheReducedAngleIsLargestOrSmallest) {
  Random random(2);
  // multiples of π/4 up to 100, and their neighbours
  const auto next = [&] {
    return (static_cast<double>(random.below(255)) - 127.0) * (kPi / 4.0) +
           random.uniform(-1e-4, 1e-4);
  };
  EXPECT_LT(largest_error(500000, next), kBound);
}

TEST(PackSinCos, ErrorIsBelowTheWiderBoundUpToTenThousand) {
  Random random(3);
  const double error = largest_error(1000000, [&] { return random.uniform(-1e4, 1e4); });
  RecordProperty("largest_error", std::to_string(error * 1e6) + "e-6");
  EXPECT_LT(error, kBound);
}

TEST(PackSinCos, SmallAnglesAreTheirOwnSines) {
  for (float angle = 1e-38F; angle < 1e-4F; angle *= 1.7F) {
    const auto a = sin_cos(Pack<float, 1>(angle));
    EXPECT_EQ(a.sin[0], angle);
    EXPECT_EQ(a.cos[0], 1.0F);
  }
}

TEST(PackSinCos, PassesNaNOn) {
  const auto a = sin_cos(Pack<float, 1>(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_TRUE(std::isnan(a.sin[0]));
  EXPECT_TRUE(std::isnan(a.cos[0]));
}

TEST(PackSinCos, PolynomialsAreFarBelowTheRounding) {
  // evaluated without rounding: what the coefficients, rounded to float, lack by themselves; half a
  // unit of single precision is 6e-8
  long double sine_error = 0.0L;
  long double cosine_error = 0.0L;
  const long double last = 0.78539816339744830962L;  // π/4
  for (int i = 0; i <= 100000; ++i) {
    const long double x = last * i / 100000;
    const long double z = x * x;
    const auto polynomial = [&](const float(&p)[3]) { return p[0] + z * (p[1] + z * p[2]); };
    const long double sine = x + x * z * polynomial(kSinePolynomial);
    const long double cosine = 1 - z / 2 + z * z * polynomial(kCosinePolynomial);
    sine_error = std::fmax(sine_error, std::fabs(sine - std::sin(x)));
    cosine_error = std::fmax(cosine_error, std::fabs(cosine - std::cos(x)));
  }
  EXPECT_LT(static_cast<double>(sine_error), 2.3e-9);
  EXPECT_LT(static_cast<double>(cosine_error), 5.2e-10);
}

std::vector<float> angles_of_all_kinds() {
  Random random(4);
  std::vector<float> angles = {0.0F, -0.0F, 1e-45F, std::numeric_limits<float>::quiet_NaN()};
  while (angles.size() < 16000) {
    const double reach = angles.size() % 2 == 0 ? 7.0 : 1e4;
    angles.push_back(static_cast<float>(random.uniform(-reach, reach)));
  }
  return angles;
}

template <class Count>
class PackSinCosOf : public testing::Test {};
TYPED_TEST_SUITE(PackSinCosOf, LaneCounts, );

TYPED_TEST(PackSinCosOf, EachLaneHasTheBitsOfALaneAlone) {
  constexpr int N = TypeParam::value;
  const std::vector<float> angles = angles_of_all_kinds();
  for (std::size_t i = 0; i < angles.size(); i += N) {
    Pack<float, N> pack;
    for (int lane = 0; lane < N; ++lane) pack.set(lane, angles[i + static_cast<std::size_t>(lane)]);
    const auto together = sin_cos(pack);
    for (int lane = 0; lane < N; ++lane) {
      const auto alone = sin_cos(Pack<float, 1>(pack[lane]));
      if (std::isnan(pack[lane])) continue;
      ASSERT_EQ(std::bit_cast<std::uint32_t>(together.sin[lane]),
                std::bit_cast<std::uint32_t>(alone.sin[0]));
      ASSERT_EQ(std::bit_cast<std::uint32_t>(together.cos[lane]),
                std::bit_cast<std::uint32_t>(alone.cos[0]));
    }
  }
}

TEST(PackSinCos, GivesTheSameBitsEverywhere) {
  // FNV-1a over the bits of results; the number came from g++ 12 on x86-64
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int byte = 0; byte < 4; ++byte) {
      hash = (hash ^ ((bits >> (8 * byte)) & 0xFFU)) * 1099511628211ULL;
    }
  };
  for (const float angle : angles_of_all_kinds()) {
    if (std::isnan(angle)) continue;
    const auto a = sin_cos(Pack<float, 1>(angle));
    add(a.sin[0]);
    add(a.cos[0]);
  }
  EXPECT_EQ(hash, 8285842223869697839ULL);
}

}  // namespace
}  // namespace shigusa
