// SPDX-License-Identifier: MIT
#include "criteria/mass_ahead.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/centre_of_mass.hpp"
#include "support/posed_body.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kHangs = kPosedAnkles.y + kHandHangs * kPosedStature;  // m, a hand's height
constexpr double kLow = kHangs - kLowReach * kPosedStature;
constexpr Vec3d kAhead{0, 0, 1};
constexpr Vec3d kAside{-1, 0, 0};

// Both hands end over the place (m, from the ankles along the floor), at a height (m), with the
// centre of mass `mass` (m) from its standing position.
Pose reaching(const Vec3d& place, double height, const Vec3d& mass) {
  Pose pose;
  pose.left.hand = pose.right.hand = place + Vec3d{0.0, height, kPosedAnkles.z};
  pose.mass = mass + Vec3d{0.0, 1.0, kPosedAnkles.z + kStandsAhead * kPosedStature};
  return pose;
}

double penalty_of(const Pose& pose, const Asked& asked = {}) {
  return penalty_of_poses<MassAhead>({pose}, asked);
}

// The penalty where the squared error of the mass is that many squares of the distance.
double penalty_for(double squares) { return squares / (1.0 + squares); }

// The penalty of a centre of mass that far (m) from people's.
double cost_of(double off) { return penalty_for(off * off / (kMassDistance * kMassDistance)); }

TEST(MassAhead, OfStandingWithTheHandsOverTheAnklesIsZero) {
  EXPECT_NEAR(penalty_of(reaching({}, kHangs, {})), 0.0, 1e-12);
}

TEST(MassAhead, InALevelReachTheMassGoesAlongByItsShare) {
  for (const Vec3d& way :
       {kAhead * 0.6, kAside * 0.6, kAhead * -0.2, kAhead * 0.3 + kAside * 0.4}) {
    EXPECT_NEAR(penalty_of(reaching(way, kHangs, way * kMassLevel)), 0.0, 1e-12);
  }
}

TEST(MassAhead, AReachUpIsALevelOne) {
  EXPECT_NEAR(penalty_of(reaching(kAhead * 0.5, 1.8, kAhead * (0.5 * kMassLevel))), 0.0, 1e-12);
}

TEST(MassAhead, InALowReachTheMassGoesAlongByMore) {
  for (const Vec3d& direction : {kAhead, kAside, kAhead * 0.6 + kAside * 0.8}) {
    const Vec3d way = direction * 0.5;
    const Vec3d mass = direction * (kMassLow * (0.5 - kMassNear));
    EXPECT_NEAR(penalty_of(reaching(way, kLow, mass)), 0.0, 1e-12);
    EXPECT_NEAR(penalty_of(reaching(way, kLow - 0.2, mass)), 0.0, 1e-12);
  }
}

TEST(MassAhead, HalfwayDownItIsBetween) {
  const double level = 0.5 * kMassLevel;
  const double low = kMassLow * (0.5 - kMassNear);
  const Vec3d mass = kAhead * (0.5 * (level + low));
  EXPECT_NEAR(penalty_of(reaching(kAhead * 0.5, 0.5 * (kHangs + kLow), mass)), 0.0, 1e-12);
}

TEST(MassAhead, ForANearLowGoalTheMassStays) {
  EXPECT_NEAR(penalty_of(reaching(kAhead * (0.9 * kMassNear), kLow, {})), 0.0, 1e-12);
}

TEST(MassAhead, IsTheSquareOfTheDistanceOverTheFloor) {
  const Vec3d way = kAhead * 0.5;
  const Vec3d mass = kAhead * (kMassLow * (0.5 - kMassNear));
  for (const Vec3d& off : {kAhead * 0.05, kAhead * -0.05, kAside * 0.05,
                           kAside * 0.03 + kAhead * 0.04, kAside * 0.05 + Vec3d{0, -0.4, 0}}) {
    EXPECT_NEAR(penalty_of(reaching(way, kLow, mass + off)), cost_of(0.05), 1e-12);
  }
}

TEST(MassAhead, StaysAsideInLevelReaches) {
  const Vec3d way = kAhead * 0.5;
  EXPECT_NEAR(penalty_of(reaching(way, kHangs, way * kMassLevel + kAside * 0.05)), 0.0, 1e-12);
  EXPECT_NEAR(penalty_of(reaching(way, kHangs, way * kMassLevel + kAhead * 0.05)), cost_of(0.05),
              1e-12);
}

TEST(MassAhead, AMassThatIsHeldBackCosts) {
  EXPECT_NEAR(penalty_of(reaching(kAhead * 0.5, kLow, {})), cost_of(kMassLow * (0.5 - kMassNear)),
              1e-12);
}

TEST(MassAhead, OnlyTheEndCounts) {
  const Pose end = reaching(kAhead * 0.5, kHangs, kAhead * (0.5 * kMassLevel));
  EXPECT_NEAR(penalty_of_poses<MassAhead>({reaching({}, kLow, kAside), end}), 0.0, 1e-12);
}

TEST(MassAhead, LooksAtTheMiddleOfTheGoalsHands) {
  Pose pose = reaching(kAhead * 0.5, kLow, kAhead * (kMassLow * (0.5 - kMassNear)));
  pose.left.hand += kAside * 0.3;
  pose.right.hand += kAside * -0.3;
  EXPECT_NEAR(penalty_of(pose), 0.0, 1e-12);
  EXPECT_GT(penalty_of(pose, {.effectors = right_hand_of(posed_body())}), 0.1);
}

TEST(MassAhead, NearerIsBetterHoweverFarItIs) {
  double before = -1.0;
  for (double off = 0.0; off < 1.0; off += 0.02) {
    const double now = penalty_of(reaching({}, kHangs, kAhead * off));
    EXPECT_GT(now, before);
    EXPECT_LT(now, 1.0);
    before = now;
  }
}

TEST(MassAhead, DistanceIsASetting) {
  EXPECT_NEAR(penalty_of(reaching({}, kHangs, kAhead * 0.1), {.scale = 0.4}), penalty_for(0.0625),
              1e-12);
}

TEST(MassAhead, WhoStartsElsewhereIsMeasuredAsWhoStands) {
  PosedBody stooped = posed_body();
  stooped.home.angles[0] = 0.8;
  const Pose pose = reaching({}, kHangs, kAhead * 0.1);
  EXPECT_NEAR(penalty_of_poses<MassAhead>({pose}, {}, stooped), cost_of(0.1), 1e-12);
}

// As of a seated body, whose legs have no joints.
TEST(MassAhead, ABodyWithoutKneesHasItsMassAtHomeWhereItStarts) {
  const PosedBody sits = posed_body_without({"left_knee", "right_knee"});
  Pose pose = reaching({}, kHangs, {});
  pose.mass = centre_of_mass(sits, home_kinematics(sits));
  EXPECT_NEAR(penalty_of_poses<MassAhead>({pose}, {}, sits), 0.0, 1e-12);
}

TEST(MassAhead, IsTheSameInAMirror) { expect_the_same_in_a_mirror<MassAhead>(); }

TEST(MassAhead, OfABodyWithoutAnklesIsZero) {
  const Pose pose = reaching({}, kHangs, kAhead * 0.1);
  ASSERT_GT(penalty_of(pose), 0.0);
  EXPECT_EQ(penalty_of_poses<MassAhead>({pose}, {}, posed_body_without({"left_foot"})), 0.0);
}

}  // namespace
}  // namespace shigusa
