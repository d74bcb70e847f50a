// SPDX-License-Identifier: MIT
#include "body/sole.hpp"

#include <gtest/gtest.h>

namespace shigusa {
namespace {

constexpr double kRounding = 1e-12;

// A sole of 0.3 m by 0.1 m, 0.08 m below the ankle, with the heel 0.1 m behind it.
Foot plain_foot() {
  Foot foot{.name = "left_foot", .node = "left_foot", .link = 0, .centre = {}, .outline = {}};
  for (const double x : {-0.05, 0.05}) {
    for (const double z : {-0.1, 0.2}) foot.outline.push_back({x, -0.08, z});
  }
  return foot;
}

Sole plain_sole() { return sole_under(plain_foot(), {}, {{}, {0.0, 0.08, 0.0}}); }

TEST(Sole, LiesFlatAtTheHeightOfTheAnkle) {
  EXPECT_NEAR(plain_sole().least_height(Mat3d{}), 0.08, kRounding);
}

TEST(Sole, TippedFootNeedsTheHeightOfItsLowestCorner) {
  const double tip = radians(30.0);
  const double sine = 0.5;
  const double cosine = sqrt(0.75);
  EXPECT_NEAR(plain_sole().least_height(rotation(Axis::x, tip)), 0.08 * cosine + 0.2 * sine, 1e-9);
  EXPECT_NEAR(plain_sole().least_height(rotation(Axis::x, -tip)), 0.08 * cosine + 0.1 * sine, 1e-9);
}

TEST(Sole, UpsideDownFootKeepsItsAnkleAboveTheFloor) {
  EXPECT_NEAR(plain_sole().least_height(rotation(Axis::x, kPi)), 0.0, 1e-9);
}

TEST(Sole, OfTurnsAboutAnAxisTheBestOneCounts) {
  const Sole sole = plain_sole();
  // turned about the vertical the sole stays flat
  EXPECT_NEAR(sole.least_height({0, 1, 0}, {0, 1, 0}), 0.08, kRounding);
  // with the toes straight down the foot stands on them, however it is turned
  EXPECT_NEAR(sole.least_height({0, 0, 1}, {0, -1, 0}), 0.2, kRounding);
  // about a level line along the foot it may lie on its side or its back
  EXPECT_NEAR(sole.least_height({0, 0, 1}, {0, 0, 1}), 0.0, kRounding);
}

// A rotation whose first axis is that unit vector.
Mat3d frame_on(const Vec3d& x) {
  const Vec3d y = normalized(cross(x, Vec3d{0.3, 0.5, -0.7}));
  return {x, y, cross(x, y)};
}

TEST(Sole, AboutAnAxisIsAsLowAsTheLowestOfItsTurns) {
  const Sole sole = plain_sole();
  const Vec3d ways[] = {{0, 0.6, 0.8}, {0.6, 0, -0.8}, {-0.48, 0.6, 0.64}, {0.8, -0.6, 0}};
  for (const Vec3d& axis : ways) {
    for (const Vec3d& direction : ways) {
      double least = 1e9;
      for (int k = 0; k < 720; ++k) {
        const Mat3d turn = frame_on(direction) * rotation(Axis::x, radians(0.5 * k));
        least = min(least, sole.least_height(turn * transpose(frame_on(axis))));
      }
      // half a degree of a corner that is 0.2 m away
      EXPECT_NEAR(sole.least_height(axis, direction), least, 2e-3);
    }
  }
}

TEST(Sole, FootThatStartsBelowTheFloorMayStayThere) {
  const Sole sole = sole_under(plain_foot(), {}, {{}, {0.0, 0.07, 0.0}});
  EXPECT_NEAR(sole.least_height(Mat3d{}), 0.07, kRounding);
}

TEST(Sole, LiftedHeelLeavesTheForefoot) {
  Foot foot = plain_foot();
  foot.heel = Heel{.forefoot = {{-0.05, -0.02, 0.0}, {0.05, -0.02, 0.06}}};
  EXPECT_NEAR(sole_under(foot, {}, {{}, {0.0, 0.02, 0.0}}).least_height(Mat3d{}), 0.02, kRounding);
}

}  // namespace
}  // namespace shigusa
