// SPDX-License-Identifier: MIT
#include "kinematics/limb.hpp"

#include <gtest/gtest.h>

#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "kinematics/forward_kinematics.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A limb with segments that need not be straight: a person's grip lies off the forearm's line.
HingedLimb bent_limb(double sign) { return {{0.01, -0.3, 0.02}, {-0.02, -0.25, 0.03}, sign}; }

// The far end by rotations instead of the closed form.
Vec3d end_of(const Vec3d& first, const Vec3d& second, double turn) {
  return first + rotation(Axis::x, turn) * second;
}

TEST(HingedLimb, LengthAndDirectionAreThoseOfTheRotatedSegments) {
  Random random(3);
  for (const double sign : {1.0, -1.0}) {
    const HingedLimb limb = bent_limb(sign);
    for (int i = 0; i < 200; ++i) {
      const double bend = random.uniform(-0.5, 3.0);
      const Vec3d end = end_of({0.01, -0.3, 0.02}, {-0.02, -0.25, 0.03}, sign * bend);
      EXPECT_NEAR(limb.across(), end.x, 1e-15);
      EXPECT_NEAR(limb.length(bend), sqrt(end.y * end.y + end.z * end.z), 1e-12);
      EXPECT_NEAR(limb.direction(bend), atan2(end.z, end.y), 1e-12);
    }
  }
}

TEST(HingedLimb, BendHasTheLengthAskedFor) {
  for (const double sign : {1.0, -1.0}) {
    const HingedLimb limb = bent_limb(sign);
    for (double length = limb.shortest() + 1e-3; length < limb.longest(); length += 0.01) {
      EXPECT_NEAR(limb.length(limb.bend(length)), length, 1e-12);
    }
    // beyond, the nearest there is; an inverse cosine near 1 has half the digits
    EXPECT_NEAR(limb.length(limb.bend(2.0)), limb.longest(), 1e-12);
    EXPECT_NEAR(limb.length(limb.bend(0.0)), limb.shortest(), 1e-8);
  }
}

TEST(HingedLimb, BendOfStraightSegmentsIsTheAnatomicalFlexion) {
  // thigh and shank downwards: the knee's dof turns the shank back, about +x
  const HingedLimb leg({0, -0.42, 0}, {0, -0.43, 0}, 1.0);
  for (const double knee : {0.1, 1.0, 2.5}) {
    EXPECT_NEAR(leg.bend(leg.length(knee)), knee, 1e-12);
    EXPECT_LT(end_of({0, -0.42, 0}, {0, -0.43, 0}, knee).z, 0.0);
  }
}

TEST(BallTurns, MakeTheRotationAgain) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const BallTurns turns{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)};
    const Mat3d r = ball_rotation(turns);
    EXPECT_LT(rotation_chord(ball_rotation(ball_turns(r)), r), 1e-14);
    const BallTurns near{turns.x + 0.1, turns.z - 0.1, turns.y + 0.1};
    const BallTurns again = ball_turns(r, near);
    // near z = 90° x and y share a turn, and rounding is spread over both
    const double tolerance = 1e-14 / abs(sin_cos(turns.z).cos);
    EXPECT_NEAR(again.x, turns.x, tolerance);
    EXPECT_NEAR(again.z, turns.z, 1e-7);
    EXPECT_NEAR(again.y, turns.y, tolerance);
  }
}

TEST(BallTurns, WithTheLimbStraightOutToTheSideKeepTheFlexion) {
  const Mat3d r = ball_rotation<double>({0.3, kPi / 2, 0.5});
  const BallTurns turns = ball_turns(r, {0.2, 1.5, 0.6});
  EXPECT_EQ(turns.x, 0.2);
  EXPECT_LT(rotation_chord(ball_rotation(turns), r), 1e-9);
}

TEST(BallTurns, AreTheHipsOfABody) {
  // both ways round: the right hip is climbed from the thigh, the left one descended
  const PosedBody posed = full_body();
  Random random(9);
  const std::vector<double> q = random_posture(posed, random);
  const Kinematics<double> placed_body = placed(posed, q);
  const auto angle = [&](const char* name) {
    const int d = posed.body.find_dof(name).value();
    return q[static_cast<std::size_t>(d)] * posed.body.dof(d).sign;
  };
  const auto link = [&](const char* name) {
    return placed_body.link_rotation(posed.body.find_dof(name).value());
  };
  const Mat3d trunk = link("right_hip.flexion");
  const BallTurns right{-angle("right_hip.flexion"), -angle("right_hip.abduction"),
                        -angle("right_hip.rotation")};
  EXPECT_LT(rotation_chord(ball_rotation(right), transpose(trunk) * link("right_knee.flexion")),
            1e-13);
  const BallTurns left{angle("left_hip.flexion"), angle("left_hip.abduction"),
                       angle("left_hip.rotation")};
  EXPECT_LT(rotation_chord(ball_rotation(left), transpose(trunk) * link("left_hip.rotation")),
            1e-13);
}

// Shank and thigh of the built-in body, upwards from the ankle.
HingedLimb standing_leg() { return {{0, 0.428, 0}, {0, 0.427, 0}, -1.0}; }

TEST(PelvisRange, HasWhatAnkleAndKneeCanDo) {
  const PelvisRange::Limits limits{radians(-50), radians(30), radians(0), radians(145)};
  const HingedLimb leg = standing_leg();
  const PelvisRange range(leg, limits);
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const double ankle = random.uniform(radians(-90), radians(70));
    const double knee = random.uniform(0.01, radians(170));
    const double over = max(max(ankle - limits.ankle_upper, limits.ankle_lower - ankle),
                            max(knee - limits.knee_upper, 0.0));
    EXPECT_NEAR(range.excess(ankle + leg.direction(knee), leg.length(knee)), over, 1e-9);
  }
  EXPECT_NEAR(range.longest(), 0.855, 1e-12);
  EXPECT_NEAR(range.shortest(), leg.length(radians(145)), 1e-12);
}

TEST(PelvisRange, OfALegThatIsTooShortGrowsWithTheGap) {
  const PelvisRange range(standing_leg(), {radians(-50), radians(30), 0.0, radians(145)});
  EXPECT_NEAR(range.excess(0.0, 0.855), 0.0, 1e-7);
  EXPECT_GT(range.excess(0.0, 0.90), 0.04);
  EXPECT_GT(range.excess(0.0, 0.95), range.excess(0.0, 0.90));
}

TEST(Unwrapped, IsTheSameAngleNearTheOther) {
  for (const double near : {-10.0, -3.2, 0.0, 3.1, 20.0}) {
    for (const double angle : {-3.0, 0.1, 3.0}) {
      const double there = unwrapped(angle, near);
      EXPECT_LE(abs(there - near), kPi + 1e-12);
      EXPECT_NEAR(sin_cos(there).sin, sin_cos(angle).sin, 1e-14);
      EXPECT_NEAR(sin_cos(there).cos, sin_cos(angle).cos, 1e-14);
    }
  }
}

}  // namespace
}  // namespace shigusa
