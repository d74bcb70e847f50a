// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <shigusa/math.hpp>

namespace shigusa {
namespace {

constexpr Vec3d kA{1, 2, 3};
constexpr Vec3d kB{-4, 0.5, 2};

TEST(Vec3, SumsDifferencesAndMultiplesAreByComponent) {
  EXPECT_EQ(kA + kB, (Vec3d{-3, 2.5, 5}));
  EXPECT_EQ(kA - kB, (Vec3d{5, 1.5, 1}));
  EXPECT_EQ(-kA, (Vec3d{-1, -2, -3}));
  EXPECT_EQ(kA * 2.0, (Vec3d{2, 4, 6}));
  EXPECT_EQ(2.0 * kA, (Vec3d{2, 4, 6}));
  Vec3d sum = kA;
  sum += kB;
  EXPECT_EQ(sum, kA + kB);
}

TEST(Vec3, IndexCountsXYZ) {
  Vec3d a = kA;
  EXPECT_EQ(a[0], 1.0);
  EXPECT_EQ(a[1], 2.0);
  EXPECT_EQ(a[2], 3.0);
  a[1] = 7.0;
  EXPECT_EQ(a, (Vec3d{1, 7, 3}));
}

TEST(Vec3, DotIsTheSumOfProducts) { EXPECT_EQ(dot(kA, kB), 3.0); }

TEST(Vec3, CrossOfTwoAxesIsTheThird) {
  const Vec3d x{1, 0, 0};
  const Vec3d y{0, 1, 0};
  const Vec3d z{0, 0, 1};
  EXPECT_EQ(cross(x, y), z);
  EXPECT_EQ(cross(y, z), x);
  EXPECT_EQ(cross(z, x), y);
}

TEST(Vec3, CrossIsPerpendicularAndAntisymmetric) {
  EXPECT_EQ(dot(cross(kA, kB), kA), 0.0);
  EXPECT_EQ(dot(cross(kA, kB), kB), 0.0);
  EXPECT_EQ(cross(kA, kB), -cross(kB, kA));
}

TEST(Vec3, NormIsTheLength) { EXPECT_EQ(norm(Vec3d{2, 3, 6}), 7.0); }

TEST(Vec3, NormalizedHasLengthOne) {
  // three roundings of half a unit each
  EXPECT_NEAR(norm(normalized(kB)), 1.0, 4e-16);
  EXPECT_EQ(normalized(Vec3d{0, 0, -5}), (Vec3d{0, 0, -1}));
}

TEST(Vec3, NormalizedOfAlmostNothingIsTheFallback) {
  EXPECT_EQ(normalized(Vec3d{}), (Vec3d{0, 1, 0}));
  EXPECT_EQ(normalized(Vec3d{1e-13, 0, 0}, {0, 0, 1}), (Vec3d{0, 0, 1}));
  EXPECT_LT(norm(normalized(Vec3d{1e-11, 0, 0}, {0, 0, 1}) - Vec3d{1, 0, 0}), 4e-16);
}

TEST(Vec3, NormalizedPassesNaNOn) {
  EXPECT_TRUE(std::isnan(normalized(Vec3d{std::numeric_limits<double>::quiet_NaN(), 0, 0}).x));
}

TEST(Vec3, SelectTakesTheFirstWhereTheConditionHolds) {
  EXPECT_EQ(select(true, kA, kB), kA);
  EXPECT_EQ(select(false, kA, kB), kB);
}

TEST(Vec3, ToScalarKeepsTheComponents) {
  const auto single = to_scalar<float>(kB);
  EXPECT_EQ(single.x, -4.0F);
  EXPECT_EQ(single.y, 0.5F);
  EXPECT_EQ(single.z, 2.0F);
}

}  // namespace
}  // namespace shigusa
