// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <shigusa/math.hpp>

#include "rotation_samples.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Mat3d kM{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
constexpr double kEpsilon = 2.3e-16;  // sin_cos's bound, and the unit of rounding near 1

TEST(Mat3, ColumnsAreTheImagesOfTheAxes) {
  EXPECT_EQ((kM * Vec3d{1, 0, 0}), kM.column(0));
  EXPECT_EQ((kM * Vec3d{0, 1, 0}), kM.column(1));
  EXPECT_EQ((kM * Vec3d{0, 0, 1}), kM.column(2));
}

TEST(Mat3, ProductAppliesTheRightOneFirst) {
  const Mat3d other{{0, 1, 0}, {2, 0, -1}, {1, 1, 1}};
  const Vec3d v{3, -2, 5};
  EXPECT_EQ((kM * other) * v, kM * (other * v));  // small integers: exact
}

TEST(Mat3, TransposeSwapsRowsAndColumns) {
  EXPECT_EQ(transpose(kM), (Mat3d{{1, 4, 7}, {2, 5, 8}, {3, 6, 10}}));
  EXPECT_EQ(transpose_times(kM, Vec3d{1, 2, 3}), transpose(kM) * (Vec3d{1, 2, 3}));
}

TEST(Mat3, SumIsByEntry) { EXPECT_EQ((Mat3d{} + kM), (Mat3d{{2, 2, 3}, {4, 6, 6}, {7, 8, 11}})); }

TEST(Rotation, FollowsTheRightHandRule) {
  // by 90°: y goes to z, z to x, x to y; the cosine of the double nearest to π/2 is 6e-17
  EXPECT_LT(norm(rotation(Axis::x, kPi / 2) * Vec3d{0, 1, 0} - Vec3d{0, 0, 1}), 1e-16);
  EXPECT_LT(norm(rotation(Axis::y, kPi / 2) * Vec3d{0, 0, 1} - Vec3d{1, 0, 0}), 1e-16);
  EXPECT_LT(norm(rotation(Axis::z, kPi / 2) * Vec3d{1, 0, 0} - Vec3d{0, 1, 0}), 1e-16);
}

TEST(Rotation, IsRodriguesFormula) {
  const Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    for (double angle = -7.0; angle < 7.0; angle += 0.01) {
      const Mat3d expected = rotation_about(axes[static_cast<int>(axis)], angle);
      ASSERT_LT(distance(rotation(axis, angle), expected), 2.0 * kEpsilon) << angle;
    }
  }
}

TEST(Rotated, MultipliesFromTheRight) {
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    const SinCos<double> a = sin_cos(0.7);
    // two products and a sum of entries up to 10: three roundings of 10 · 1.1e-16
    EXPECT_LT(distance(rotated(kM, axis, a), kM * rotation(axis, 0.7)), 4e-15);
  }
}

// rotation_vector claims an error below 1e-14.
constexpr double kVectorBound = 1e-14;

double vector_error(const Vec3d& axis, double angle) {
  return norm(rotation_vector(rotation_about(axis, angle)) - axis * angle);
}

TEST(RotationVector, OfTheIdentityIsZero) { EXPECT_EQ(rotation_vector(Mat3d{}), Vec3d{}); }

TEST(RotationVector, IsAxisTimesAngle) {
  Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const double angle = random.uniform(0.0, kPi - 1e-6);
    const Vec3d axis = random_direction(random);
    ASSERT_LT(vector_error(axis, angle), kVectorBound) << angle;
  }
}

TEST(RotationVector, KeepsItsDigitsNearZero) {
  Random random(2);
  for (double angle = 1e-15; angle < 1e-3; angle *= 1.1) {
    // the sines are exact to rounding, so the error is relative
    ASSERT_LT(vector_error(random_direction(random), angle), 1e-15 * angle) << angle;
  }
}

TEST(RotationVector, KeepsItsAccuracyNearPi) {
  Random random(3);
  // from 2e-15 before π on rounding may take the angle for one beyond, which is the opposite vector
  for (double gap = 2e-15; gap < 1.0; gap *= 1.01) {
    ASSERT_LT(vector_error(random_direction(random), kPi - gap), kVectorBound) << gap;
  }
}

TEST(RotationVector, IsAccurateWhereItsFormulasSwitch) {
  Random random(4);
  for (const double angle : {kPi / 2, 0.5e-9}) {
    for (int i = 0; i < 10000; ++i) {
      const double near_it = angle * (1.0 + random.uniform(-1e-6, 1e-6));
      ASSERT_LT(vector_error(random_direction(random), near_it), kVectorBound);
    }
  }
}

TEST(RotationVector, AtPiIsEitherOfTheOppositeVectors) {
  Random random(5);
  for (int i = 0; i < 10000; ++i) {
    const Vec3d axis = random_direction(random);
    const Vec3d v = rotation_vector(rotation_about(axis, kPi));
    ASSERT_LT(std::fmin(norm(v - axis * kPi), norm(v + axis * kPi)), kVectorBound);
  }
}

TEST(RotationVector, AtPiAboutTheAxesIsExact) {
  EXPECT_EQ(rotation_vector(Mat3d{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}), (Vec3d{kPi, 0, 0}));
  EXPECT_EQ(rotation_vector(Mat3d{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}), (Vec3d{0, kPi, 0}));
  EXPECT_EQ(rotation_vector(Mat3d{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}), (Vec3d{0, 0, kPi}));
}

TEST(RotationVector, AngleIsAtMostPi) {
  Random random(6);
  for (int i = 0; i < 100000; ++i) {
    const Mat3d r = rotation_about(random_direction(random), random.uniform(-10.0, 10.0));
    // π is rounded, and the vector's length twice
    ASSERT_LT(norm(rotation_vector(r)), kPi + 2e-15);
  }
}

// A world rotation of a link, and the same turned by a rotation about a world axis.
struct TurnedLink {
  Vec3d axis;
  double angle;
  Mat3d from;
  Mat3d to;

  TurnedLink(double turned, Random& random)
      : axis(random_direction(random)),
        angle(turned),
        from(rotation_about(random_direction(random), random.uniform(0.0, kPi))),
        to(rotation_about(axis, angle) * from) {}
};

TEST(RotationSine, IsTheAxisTimesTheSineOfTheAngle) {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const TurnedLink link(random.uniform(0.0, kPi), random);
    // three cross products of unit vectors: a dozen roundings near 1
    ASSERT_LT(norm(rotation_sine(link.from, link.to) - link.axis * std::sin(link.angle)), 2e-15);
  }
}

TEST(RotationSine, IsTheRotationVectorToTheThirdOrder) {
  Random random(8);
  for (double angle = 1e-6; angle < 0.5; angle *= 1.5) {
    const TurnedLink link(angle, random);
    const Vec3d error = rotation_sine(link.from, link.to) - link.axis * angle;
    ASSERT_LT(norm(error), angle * angle * angle / 6.0 + 2e-15) << angle;
  }
}

TEST(RotationSine, OfTheSameRotationIsZero) {
  Random random(9);
  const TurnedLink link(0.0, random);
  EXPECT_EQ(rotation_sine(link.from, link.from), Vec3d{});
}

TEST(RotationChord, IsTwiceTheSineOfHalfTheAngle) {
  Random random(10);
  for (int i = 0; i < 20000; ++i) {
    const TurnedLink link(random.uniform(0.0, kPi), random);
    // entries are off by a few roundings each, nine of them under the root
    ASSERT_NEAR(rotation_chord(link.from, link.to), 2.0 * std::sin(link.angle / 2.0), 2e-15);
  }
}

TEST(RotationChord, KeepsItsDigitsNearZeroAndGrowsToHalfATurn) {
  Random random(11);
  double before = 0.0;
  for (double angle = 1e-7; angle < kPi; angle *= 1.3) {
    const TurnedLink link(angle, random);
    const double chord = rotation_chord(link.from, link.to);
    ASSERT_GT(chord, before);
    ASSERT_NEAR(chord, angle, angle * angle * angle / 24.0 + 1e-15) << angle;
    before = chord;
  }
}

TEST(RotationChord, DoesNotDependOnTheOrder) {
  Random random(12);
  const TurnedLink link(1.2, random);
  EXPECT_EQ(rotation_chord(link.from, link.to), rotation_chord(link.to, link.from));
  EXPECT_EQ(rotation_chord(link.from, link.from), 0.0);
}

}  // namespace
}  // namespace shigusa
