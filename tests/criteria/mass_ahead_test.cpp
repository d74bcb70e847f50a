// SPDX-License-Identifier: MIT
#include "criteria/mass_ahead.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/posed_body.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kHeight = 1.0;  // m, of the hands at the start
constexpr double kLow = kHeight - kLowReach * kPosedStature;
constexpr Vec3d kAhead{0, 0, 1};
constexpr Vec3d kAside{-1, 0, 0};

// Both hands end over the place (m, from the ankles over the floor), at a height (m), while the
// centre of mass goes by `mass` (m).
std::vector<Pose> reaching(const Vec3d& place, double height, const Vec3d& mass) {
  std::vector<Pose> poses(2);
  poses[0].left.hand = poses[0].right.hand = {0.0, kHeight, 0.1};
  poses[0].mass = {0.02, 1.0, 0.03};
  poses[1].left.hand = poses[1].right.hand = place + Vec3d{0.0, height, kPosedAnkles};
  poses[1].mass = poses[0].mass + mass;
  return poses;
}

double penalty_of(const std::vector<Pose>& poses, const MassAheadSettings& settings = {}) {
  return penalty_of_poses<MassAhead>(poses, settings);
}

// The penalty of a centre of mass that is so far (m) from where people have it.
double cost_of(double off) { return off * off / (kMassDistance * kMassDistance); }

TEST(MassAhead, OfStandingWithTheHandsOverTheAnklesIsZero) {
  EXPECT_EQ(penalty_of(reaching({}, kHeight, {})), 0.0);
}

TEST(MassAhead, InALevelReachTheMassGoesAlongByItsShare) {
  for (const Vec3d& way :
       {kAhead * 0.6, kAside * 0.6, kAhead * -0.2, kAhead * 0.3 + kAside * 0.4}) {
    EXPECT_NEAR(penalty_of(reaching(way, kHeight, way * kMassLevel)), 0.0, 1e-12);
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
  EXPECT_NEAR(penalty_of(reaching(kAhead * 0.5, 0.5 * (kHeight + kLow), mass)), 0.0, 1e-12);
}

TEST(MassAhead, ForANearLowGoalTheMassStays) {
  EXPECT_NEAR(penalty_of(reaching(kAhead * (0.9 * kMassNear), kLow, {})), 0.0, 1e-12);
}

TEST(MassAhead, IsTheSquareOfTheDistanceOverTheFloor) {
  const Vec3d way = kAhead * 0.5;
  for (const Vec3d& off : {kAhead * 0.05, kAhead * -0.05, kAside * 0.05,
                           kAside * 0.03 + kAhead * 0.04, kAside * 0.05 + Vec3d{0, -0.4, 0}}) {
    EXPECT_NEAR(penalty_of(reaching(way, kHeight, way * kMassLevel + off)), cost_of(0.05), 1e-12);
  }
}

TEST(MassAhead, AMassThatIsHeldBackCosts) {
  EXPECT_NEAR(penalty_of(reaching(kAhead * 0.5, kLow, {})), cost_of(kMassLow * (0.5 - kMassNear)),
              1e-12);
}

TEST(MassAhead, OnlyTheEndCounts) {
  std::vector<Pose> poses = reaching(kAhead * 0.5, kHeight, kAhead * (0.5 * kMassLevel));
  poses.insert(poses.begin() + 1, reaching({}, kLow, kAside)[1]);
  EXPECT_NEAR(penalty_of(poses), 0.0, 1e-12);
}

TEST(MassAhead, LooksAtTheMiddleOfTheGoalsHands) {
  std::vector<Pose> poses = reaching(kAhead * 0.5, kHeight, kAhead * (0.5 * kMassLevel));
  poses[1].left.hand += kAside * 0.3;
  poses[1].right.hand += kAside * -0.3;
  EXPECT_NEAR(penalty_of(poses), 0.0, 1e-12);
  EXPECT_NEAR(penalty_of(poses, {.effectors = right_hand_of(posed_body())}),
              cost_of(0.3 * kMassLevel), 1e-12);
}

TEST(MassAhead, IsFullAtItsDistanceAndBeyond) {
  EXPECT_NEAR(penalty_of(reaching({}, kHeight, kAhead * kMassDistance)), 1.0, 1e-12);
  EXPECT_EQ(penalty_of(reaching({}, kHeight, kAhead * (2.0 * kMassDistance))), 1.0);
}

TEST(MassAhead, DistanceIsASetting) {
  EXPECT_NEAR(penalty_of(reaching({}, kHeight, kAhead * 0.1), {.distance = 0.4}), 0.0625, 1e-12);
}

TEST(MassAhead, IsTheSameInAMirror) {
  std::vector<Pose> poses = lopsided_poses();
  const double penalty = penalty_of(poses);
  EXPECT_GT(penalty, 0.0);
  EXPECT_LT(penalty, 1.0);
  for (Pose& pose : poses) pose = mirrored(pose);
  EXPECT_DOUBLE_EQ(penalty_of(poses), penalty);
}

TEST(MassAhead, OfABodyWithoutAnklesIsZero) {
  const std::vector<Pose> poses = reaching({}, kHeight, kAhead * 0.1);
  ASSERT_GT(penalty_of(poses), 0.0);
  EXPECT_EQ(penalty_of_poses<MassAhead>(poses, {}, posed_body_without({"left_foot"})), 0.0);
}

TEST(MassAhead, ForgetsWhatItSaw) {
  MassAhead<double> mass(posed_body());
  show_poses(posed_body(), reaching({}, kHeight, kAhead * 0.1), mass);
  EXPECT_GT(mass.penalty(), 0.0);
  mass.reset();
  EXPECT_EQ(mass.penalty(), 0.0);
  // the way begins anew
  show_poses(posed_body(), {reaching({}, kHeight, kAhead * 0.1)[1]}, mass);
  EXPECT_EQ(mass.penalty(), 0.0);
}

TEST(MassAhead, OfNoFramesIsZero) { EXPECT_EQ(penalty_of({}), 0.0); }

}  // namespace
}  // namespace shigusa
