// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <shigusa/math.hpp>
#include <shigusa/run.hpp>

// The reference is the C library in long double. With 64 bits of precision its own error, below
// 1e-19 (sin and cos) and 3e-19 (inverse functions up to π), is negligible beside the bounds.
namespace shigusa {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The largest error of sine or cosine over all angles returned by `next`.
template <class Next>
double largest_sin_cos_error(int count, Next&& next) {
  long double largest = 0.0L;
  for (int i = 0; i < count; ++i) {
    const double angle = next();
    const SinCos<double> a = sin_cos(angle);
    const long double exact = static_cast<long double>(angle);
    largest = std::fmax(largest, std::fabs(static_cast<long double>(a.sin) - std::sin(exact)));
    largest = std::fmax(largest, std::fabs(static_cast<long double>(a.cos) - std::cos(exact)));
  }
  return static_cast<double>(largest);
}

double atan2_error(double y, double x) {
  const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
  return static_cast<double>(std::fabs(static_cast<long double>(atan2(y, x)) - exact));
}

// sin_cos: 2.3e-16. The reduced argument is rounded twice below 1 (2 · 5.6e-17), which the
// derivative, at most sin(π/4) for the cosine, brings to 7.9e-17; 1 - z/2 adds 5.6e-17 and 2.8e-17
// from z, the last sum 5.6e-17, the small terms 0.5e-17: 2.23e-16. The sine has less.
constexpr double kSinCosBound = 2.3e-16;

TEST(SinCos, ErrorIsBelowTheBoundOnADenseGridOfOneTurn) {
  int i = 0;
  EXPECT_LT(largest_sin_cos_error(200001, [&] { return (i++ - 100000) * (kPi / 100000.0); }),
            kSinCosBound);
}

TEST(SinCos, ErrorIsBelowTheBoundUpToAMillion) {
  Random random(1);
  EXPECT_LT(largest_sin_cos_error(200000, [&] { return random.uniform(-1e2, 1e2); }), kSinCosBound);
  EXPECT_LT(largest_sin_cos_error(200000, [&] { return random.uniform(-1e6, 1e6); }), kSinCosBound);
}

TEST(SinCos, ErrorIsBelowTheBoundWhereTheReducedArgumentIsLargest) {
  Random random(2);
  // odd multiples of π/4, up to a million
  const auto next = [&] {
    return (2.0 * random.below(636000) + 1.0) * (kPi / 4.0) + random.uniform(-1e-6, 1e-6);
  };
  EXPECT_LT(largest_sin_cos_error(200000, next), kSinCosBound);
}

TEST(SinCos, ErrorIsRelativeNearMultiplesOfHalfPi) {
  // the double nearest to k π/2 has a sine or cosine of about its distance, mostly below 1e-11: it
  // keeps its leading digits only if the reduction loses none
  for (int k = 1; k < 600000; k += 7) {
    const double angle = k * (kPi / 2.0);
    const SinCos<double> a = sin_cos(angle);
    const double small = k % 2 == 0 ? a.sin : a.cos;
    const long double exact = k % 2 == 0 ? std::sin(static_cast<long double>(angle))
                                         : std::cos(static_cast<long double>(angle));
    const long double error = std::fabs(static_cast<long double>(small) - exact);
    ASSERT_LT(error, std::fabs(exact) * 4e-16L) << k;
  }
}

TEST(SinCos, ErrorIsBelowTheWiderBoundUpToABillion) {
  Random random(3);
  EXPECT_LT(largest_sin_cos_error(100000, [&] { return random.uniform(-1e9, 1e9); }), 1e-7);
}

TEST(SinCos, IsNaNOutOfRange) {
  for (const double angle : {1.6e9, 1e17, 1e20, 1e300, kInfinity, kNaN}) {
    for (const double sign : {1.0, -1.0}) {
      EXPECT_TRUE(std::isnan(sin_cos(sign * angle).sin)) << angle;
      EXPECT_TRUE(std::isnan(sin_cos(sign * angle).cos)) << angle;
    }
  }
}

TEST(SinCos, OfZeroIsExact) {
  EXPECT_EQ(sin_cos(0.0).sin, 0.0);
  EXPECT_EQ(sin_cos(0.0).cos, 1.0);
}

TEST(SinCos, OfTheOppositeAngleIsTheMirrorImage) {
  Random random(4);
  for (int i = 0; i < 100000; ++i) {
    const double angle = random.uniform(-1e3, 1e3);
    ASSERT_EQ(sin_cos(-angle).sin, -sin_cos(angle).sin) << angle;
    ASSERT_EQ(sin_cos(-angle).cos, sin_cos(angle).cos) << angle;
  }
}

TEST(SinCos, OfDenormalsIsThatOfTheAngle) {
  for (const double angle : {5e-324, -5e-324, 1e-310, 1e-300}) {
    EXPECT_EQ(sin_cos(angle).sin, angle);
    EXPECT_EQ(sin_cos(angle).cos, 1.0);
  }
}

// atan2: 7e-16. Up to 45°: t is rounded (5.6e-17 in the angle), u by its numerator (1.2e-16), the
// series and the last sum add 1.4e-16: 3.2e-16. The half axis adds the error of the double π,
// 1.2e-16, and the last sum half a unit in the last place of up to π, 2.2e-16.
constexpr double kAtan2Bound = 7e-16;

TEST(Atan2, ErrorIsBelowTheBoundOnADenseCircle) {
  for (int i = 0; i < 200000; ++i) {
    const double turn = i * (2.0 * kPi / 200000.0);
    ASSERT_LT(atan2_error(std::sin(turn), std::cos(turn)), kAtan2Bound) << i;
  }
}

TEST(Atan2, ErrorIsBelowTheBoundAtAllScales) {
  Random random(5);
  const auto number = [&] {
    return std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.below(2000)) - 1000);
  };
  for (int i = 0; i < 200000; ++i) {
    const double y = random.uniform(-1.0, 1.0);
    const double x = random.uniform(-1.0, 1.0);
    ASSERT_LT(atan2_error(y, x), kAtan2Bound) << y << ' ' << x;
    const double far_y = number();
    const double far_x = number();
    ASSERT_LT(atan2_error(far_y, far_x), kAtan2Bound) << far_y << ' ' << far_x;
  }
}

TEST(Atan2, ErrorIsBelowTheBoundWhereTheReductionsSwitch) {
  Random random(6);
  for (const double slope : {0.26794919243112270647, 1.0, 3.7320508075688772935, 1e-300, 1e300}) {
    for (int i = 0; i < 20000; ++i) {
      const double y = slope * (1.0 + random.uniform(-1e-9, 1e-9));
      ASSERT_LT(atan2_error(y, 1.0), kAtan2Bound) << y;
      ASSERT_LT(atan2_error(y, -1.0), kAtan2Bound) << y;
      ASSERT_LT(atan2_error(-y, -1.0), kAtan2Bound) << y;
    }
  }
}

TEST(Atan2, AlongTheAxesIsExact) {
  EXPECT_EQ(atan2(0.0, 2.0), 0.0);
  EXPECT_EQ(atan2(2.0, 0.0), kPi / 2.0);
  EXPECT_EQ(atan2(0.0, -2.0), kPi);
  EXPECT_EQ(atan2(-2.0, 0.0), -kPi / 2.0);
}

TEST(Atan2, IsAboveMinusPi) {
  EXPECT_EQ(atan2(-0.0, -1.0), kPi);
  EXPECT_GT(atan2(-1e-10, -1.0), -kPi);
}

TEST(Atan2, OfTheNullVectorIsZero) {
  for (const double y : {0.0, -0.0}) {
    for (const double x : {0.0, -0.0}) EXPECT_EQ(atan2(y, x), 0.0);
  }
}

TEST(Atan2, OfOneInfinityIsItsHalfAxis) {
  EXPECT_EQ(atan2(kInfinity, 1.0), kPi / 2.0);
  EXPECT_EQ(atan2(-kInfinity, 1.0), -kPi / 2.0);
  EXPECT_EQ(atan2(1.0, -kInfinity), kPi);
  EXPECT_EQ(atan2(1.0, kInfinity), 0.0);
}

TEST(Atan2, PassesNaNOn) {
  EXPECT_TRUE(std::isnan(atan2(kNaN, 1.0)));
  EXPECT_TRUE(std::isnan(atan2(1.0, kNaN)));
  EXPECT_TRUE(std::isnan(atan2(kNaN, kNaN)));
  EXPECT_TRUE(std::isnan(atan2(kNaN, 0.0)));
  EXPECT_TRUE(std::isnan(atan2(kInfinity, kInfinity)));
}

TEST(Atan2, UndoesSinCos) {
  Random random(7);
  for (int i = 0; i < 100000; ++i) {
    const double angle = random.uniform(-kPi, kPi);
    const SinCos<double> a = sin_cos(angle);
    // both bounds, and sin_cos's in each of two coordinates
    ASSERT_NEAR(atan2(a.sin, a.cos), angle, kAtan2Bound + 2.0 * kSinCosBound);
  }
}

// asin and acos: atan2's bound, and 1.4e-16 from the three roundings in √((1 - c)(1 + c)).
TEST(AsinAcos, ErrorIsBelowTheBound) {
  Random random(8);
  for (int i = 0; i < 200000; ++i) {
    double x = random.uniform(-1.0, 1.0);
    if (i % 2 == 0) x = (x < 0.0 ? -1.0 : 1.0) * (1.0 - std::ldexp(1.0, -(i % 107) / 2));
    const auto exact = static_cast<long double>(x);
    ASSERT_LT(std::fabs(static_cast<long double>(asin(x)) - std::asin(exact)), 1e-15L) << x;
    ASSERT_LT(std::fabs(static_cast<long double>(acos(x)) - std::acos(exact)), 1e-15L) << x;
  }
}

TEST(AsinAcos, ClampTheArgument) {
  EXPECT_EQ(asin(1.0 + 1e-12), kPi / 2.0);
  EXPECT_EQ(asin(-2.0), -kPi / 2.0);
  EXPECT_EQ(acos(1.0 + 1e-12), 0.0);
  EXPECT_EQ(acos(-2.0), kPi);
}

TEST(AsinAcos, PassNaNOn) {
  EXPECT_TRUE(std::isnan(asin(kNaN)));
  EXPECT_TRUE(std::isnan(acos(kNaN)));
}

TEST(Scalar, TrigonometryGivesTheSameBitsEverywhere) {
  // FNV-1a over the bytes of results; the number came from g++ 12 on x86-64
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    for (int byte = 0; byte < 8; ++byte) {
      hash = (hash ^ ((bits >> (8 * byte)) & 0xFFU)) * 1099511628211ULL;
    }
  };
  Random random(9);
  for (int i = 0; i < 20000; ++i) {
    const double angle = random.uniform(-100.0, 100.0);
    const SinCos<double> a = sin_cos(angle);
    add(a.sin);
    add(a.cos);
    add(atan2(angle, random.uniform(-100.0, 100.0)));
    add(asin(a.cos));
    add(acos(a.sin));
  }
  EXPECT_EQ(hash, 12236760976783528378ULL);
}

TEST(Scalar, DegreesAndRadiansAreInverse) {
  EXPECT_EQ(radians(180.0), kPi);
  EXPECT_EQ(degrees(kPi), 180.0);
  EXPECT_NEAR(degrees(radians(37.5)), 37.5, 37.5 * 4.0 * std::numeric_limits<double>::epsilon());
}

TEST(Scalar, SelectTakesTheFirstWhereTheConditionHolds) {
  EXPECT_EQ(select(true, 1.0, 2.0), 1.0);
  EXPECT_EQ(select(false, 1.0, 2.0), 2.0);
}

TEST(Scalar, MinAndMaxOfNaNAreTheFirstArgument) {
  EXPECT_EQ(min(1.0, kNaN), 1.0);
  EXPECT_EQ(max(1.0, kNaN), 1.0);
  EXPECT_TRUE(std::isnan(min(kNaN, 1.0)));
  EXPECT_TRUE(std::isnan(max(kNaN, 1.0)));
}

TEST(Scalar, ClampKeepsToTheRangeAndPassesNaNOn) {
  EXPECT_EQ(clamp(-3.0, -1.0, 2.0), -1.0);
  EXPECT_EQ(clamp(0.5, -1.0, 2.0), 0.5);
  EXPECT_EQ(clamp(3.0, -1.0, 2.0), 2.0);
  EXPECT_TRUE(std::isnan(clamp(kNaN, -1.0, 2.0)));
}

TEST(Scalar, IsFiniteRefusesInfinitiesAndNaN) {
  EXPECT_TRUE(is_finite(0.0));
  EXPECT_TRUE(is_finite(std::numeric_limits<double>::max()));
  EXPECT_FALSE(is_finite(kInfinity));
  EXPECT_FALSE(is_finite(-kInfinity));
  EXPECT_FALSE(is_finite(kNaN));
}

// natural_log and exponential: 5e-16. Rounding s or the reduced argument, the series and the last
// sum bring four units in the last place at most, of 1.1e-16 each.
double log_error(double x) {
  const long double exact = std::log(static_cast<long double>(x));
  return static_cast<double>(std::fabs((static_cast<long double>(natural_log(x)) - exact) / exact));
}

double exponential_error(double x) {
  const long double exact = std::exp(static_cast<long double>(x));
  return static_cast<double>(std::fabs((static_cast<long double>(exponential(x)) - exact) / exact));
}

constexpr double kLogBound = 5e-16;

TEST(NaturalLog, RelativeErrorIsBelowTheBoundAcrossAllExponents) {
  Random random(11);
  double largest = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const int exponent = static_cast<int>(random.below(2098)) - 1074;
    largest = std::fmax(largest, log_error(std::ldexp(random.uniform(1.0, 2.0), exponent)));
  }
  EXPECT_LT(largest, kLogBound);
}

TEST(NaturalLog, RelativeErrorIsBelowTheBoundNearOneAndNearTheSeam) {
  Random random(12);
  double largest = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const double gap =
        std::ldexp(random.uniform(0.5, 1.0), -1 - static_cast<int>(random.below(50)));
    largest = std::fmax(largest, log_error(1.0 + gap));
    largest = std::fmax(largest, log_error(1.0 - gap));
    largest = std::fmax(largest, log_error(std::sqrt(2.0) + gap * 1e-3));
    largest = std::fmax(largest, log_error(std::sqrt(2.0) - gap * 1e-3));
  }
  EXPECT_LT(largest, kLogBound);
}

TEST(NaturalLog, SpecialValues) {
  EXPECT_EQ(natural_log(1.0), 0.0);
  EXPECT_EQ(natural_log(0.0), -kInfinity);
  EXPECT_EQ(natural_log(-0.0), -kInfinity);
  EXPECT_EQ(natural_log(kInfinity), kInfinity);
  for (const double x : {-1.0, -kInfinity, kNaN}) EXPECT_TRUE(std::isnan(natural_log(x)));
}

TEST(Exponential, RelativeErrorIsBelowTheBoundForNormalResults) {
  Random random(13);
  double largest = 0.0;
  for (int i = 0; i < 200000; ++i) {
    largest = std::fmax(largest, exponential_error(random.uniform(-708.0, 709.7)));
    largest = std::fmax(largest, exponential_error(random.uniform(-1.0, 1.0)));
  }
  EXPECT_LT(largest, kLogBound);
}

TEST(Exponential, SpecialValuesAndTheEndsOfTheRange) {
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(kInfinity), kInfinity);
  EXPECT_EQ(exponential(-kInfinity), 0.0);
  EXPECT_EQ(exponential(709.9), kInfinity);
  EXPECT_EQ(exponential(-745.9), 0.0);
  // the least subnormal number is all that is left there
  EXPECT_EQ(exponential(-744.5), 0x1p-1074);
  EXPECT_TRUE(std::isnan(exponential(kNaN)));
}

}  // namespace
}  // namespace shigusa
