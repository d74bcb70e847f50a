// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <shigusa/math.hpp>

#include "rotation_samples.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kHalfRoot = 0.70710678118654752440;  // √½

// axis · sin(angle/2), cos(angle/2) from the C library
Quatd quat_about(const Vec3d& axis, double angle) {
  const Vec3d v = axis * std::sin(angle / 2);
  return {v.x, v.y, v.z, std::cos(angle / 2)};
}

// The largest difference of two components, of q and -q whichever is nearer.
double quat_distance(const Quatd& a, const Quatd& b) {
  const double sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0.0 ? -1.0 : 1.0;
  return std::fmax(std::fmax(std::fabs(a.x - sign * b.x), std::fabs(a.y - sign * b.y)),
                   std::fmax(std::fabs(a.z - sign * b.z), std::fabs(a.w - sign * b.w)));
}

// The parts are sums of four numbers, each rounded near 1, then scaled: some ten half units.
constexpr double kBound = 1e-15;

TEST(Quat, ProductOfTheUnitsIsHamiltons) {
  const Quatd i{1, 0, 0, 0};
  const Quatd j{0, 1, 0, 0};
  const Quatd k{0, 0, 1, 0};
  EXPECT_EQ(i * j, k);
  EXPECT_EQ(j * k, i);
  EXPECT_EQ(k * i, j);
  EXPECT_EQ(i * i, (Quatd{0, 0, 0, -1}));
}

TEST(Quat, ProductIsTheProductOfMatrices) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const Quatd a = quat_about(random_direction(random), random.uniform(-7.0, 7.0));
    const Quatd b = quat_about(random_direction(random), random.uniform(-7.0, 7.0));
    // entries near 1 through some ten roundings on either side
    ASSERT_LT(distance(to_matrix(a * b), to_matrix(a) * to_matrix(b)), 4e-15);
  }
}

TEST(AxisRotation, IsTheMatrixRotation) {
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    for (double angle = -7.0; angle < 7.0; angle += 0.1) {
      EXPECT_LT(distance(to_matrix(axis_rotation(axis, angle)), rotation(axis, angle)), 2e-15);
    }
  }
}

TEST(ToMatrix, IsRodriguesFormula) {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const Vec3d axis = random_direction(random);
    const double angle = random.uniform(-7.0, 7.0);
    ASSERT_LT(distance(to_matrix(quat_about(axis, angle)), rotation_about(axis, angle)), 2e-15);
  }
}

TEST(ToQuat, IsRightInAllFourBranches) {
  Random random(3);
  int branch_counts[4] = {};
  for (int i = 0; i < 40000; ++i) {
    const Vec3d axis = random_direction(random);
    const double angle = random.uniform(0.0, kPi);
    const Quatd expected = quat_about(axis, angle);
    ASSERT_LT(quat_distance(to_quat(rotation_about(axis, angle)), expected), kBound);
    // the branch is that of the largest part
    const double parts[] = {std::fabs(expected.x), std::fabs(expected.y), std::fabs(expected.z),
                            std::fabs(expected.w)};
    int largest = 0;
    for (int k = 1; k < 4; ++k) largest = parts[k] > parts[largest] ? k : largest;
    ++branch_counts[largest];
  }
  for (const int count : branch_counts) EXPECT_GT(count, 1000);
}

TEST(ToQuat, IsRightAtHalfTurnsAboutTheAxes) {
  EXPECT_EQ(to_quat(Mat3d{}), (Quatd{0, 0, 0, 1}));
  EXPECT_EQ(to_quat(Mat3d{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}), (Quatd{1, 0, 0, 0}));
  EXPECT_EQ(to_quat(Mat3d{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}), (Quatd{0, 1, 0, 0}));
  EXPECT_EQ(to_quat(Mat3d{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}), (Quatd{0, 0, 1, 0}));
}

TEST(ToQuat, IsRightWhereTwoOrMorePartsAreEqual) {
  Random random(4);
  const Vec3d diagonals[] = {{kHalfRoot, kHalfRoot, 0},
                             {0, kHalfRoot, kHalfRoot},
                             {kHalfRoot, 0, -kHalfRoot},
                             normalized(Vec3d{1, 1, 1}),
                             normalized(Vec3d{1, -1, 1})};
  for (const Vec3d& axis : diagonals) {
    // 120° about (1, 1, 1) has four equal parts
    for (const double angle : {kPi / 2, 2 * kPi / 3, kPi - 1e-9, kPi}) {
      EXPECT_LT(quat_distance(to_quat(rotation_about(axis, angle)), quat_about(axis, angle)),
                kBound);
    }
  }
}

TEST(ToQuat, HasLengthOneAndWNotNegative) {
  Random random(5);
  for (int i = 0; i < 10000; ++i) {
    const Quatd q = to_quat(rotation_about(random_direction(random), random.uniform(-10, 10)));
    ASSERT_GE(q.w, 0.0);
    ASSERT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1.0, kBound);
  }
}

TEST(ToQuat, IsUndoneByToMatrix) {
  Random random(6);
  for (int i = 0; i < 10000; ++i) {
    const Mat3d r = rotation_about(random_direction(random), random.uniform(-10, 10));
    ASSERT_LT(distance(to_matrix(to_quat(r)), r), 2e-15);
  }
}

}  // namespace
}  // namespace shigusa
