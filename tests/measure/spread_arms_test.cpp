// SPDX-License-Identifier: MIT
// Postures of the arms in which nobody stands.
#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "human/landmark_points.hpp"
#include "human/stance.hpp"

namespace shigusa {
namespace {

// A standing person with straight arms, `raised` from hanging and turned by `yaw` from the side to
// the front, both in degrees; the left forearm bent by `bend`.
Landmarks with_arms(double raised, double yaw, double bend = 0.0) {
  Landmarks person = standing_landmarks(1.7, 0.0);
  for (const Side side : kBothSides) {
    Landmarks::Arm& arm = person.arm(side);
    const double out = side == Side::left ? 1.0 : -1.0;
    const auto along = [&](double angle) {
      const auto [s, c] = sin_cos(radians(angle));
      const auto [ahead, aside] = sin_cos(radians(yaw));
      return Vec3d{out * s * aside, -c, s * ahead};
    };
    arm.elbow = arm.shoulder + along(raised) * 0.3;
    arm.wrist = arm.elbow + along(raised + (side == Side::left ? bend : 0.0)) * 0.25;
    arm.fingertip = arm.wrist + along(raised) * 0.18;
  }
  return person;
}

TEST(SpreadArms, AreAnAATAndAllThatIsNearlyOne) {
  for (const double raised : {35.0, 60.0, 90.0, 105.0, 115.0}) {
    for (const double yaw : {-20.0, 0.0, 20.0}) {
      EXPECT_TRUE(spreads_arms(with_arms(raised, yaw))) << raised << " " << yaw;
    }
  }
  EXPECT_FALSE(spreads_arms(with_arms(10.0, 0.0)));
  EXPECT_FALSE(spreads_arms(with_arms(150.0, 0.0)));
  EXPECT_FALSE(spreads_arms(with_arms(90.0, 0.0, 60.0)));
}

TEST(SpreadArms, AreHeldStraightAheadToo) {
  for (const double raised : {70.0, 90.0, 115.0}) {
    for (const double yaw : {65.0, 90.0, 100.0}) {
      EXPECT_TRUE(spreads_arms(with_arms(raised, yaw))) << raised << " " << yaw;
    }
  }
  // people who reach ahead and down, or bend an elbow, may stand so
  EXPECT_FALSE(spreads_arms(with_arms(45.0, 90.0)));
  EXPECT_FALSE(spreads_arms(with_arms(90.0, 90.0, 60.0)));
  EXPECT_FALSE(spreads_arms(with_arms(90.0, -90.0)));
}

}  // namespace
}  // namespace shigusa
