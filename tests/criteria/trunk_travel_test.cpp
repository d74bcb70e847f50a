// SPDX-License-Identifier: MIT
#include "criteria/trunk_travel.hpp"

#include <gtest/gtest.h>

#include "support/posed_body.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kShoulder{-0.2, 1.4, 0.0};
constexpr double kAlone = kArmAlone * kPosedArm;  // m, as far as the arm reaches alone

// The right shoulder goes by `moved` (m) while the hand ends so far (m) from where the shoulder
// was.
std::vector<Pose> reaching(double far, const Vec3d& moved) {
  std::vector<Pose> poses(2);
  poses[0].right = {kShoulder, kShoulder + Vec3d{0, -0.4, 0}};
  poses[1].right = {kShoulder + moved, kShoulder + Vec3d{0, 0, far}};
  return poses;
}

double penalty_of(const std::vector<Pose>& poses, double distance = kTravelDistance) {
  return penalty_of_poses<TrunkTravel>(
      poses, {.distance = distance, .effectors = right_hand_of(posed_body())});
}

// The penalty of a shoulder's way that is too long, or too short, by so much (m).
double cost_of(double more) { return more * more / (kTravelDistance * kTravelDistance); }

TEST(TrunkTravel, WithinTheArmsReachTheTrunkKeepsOut) {
  EXPECT_EQ(penalty_of(reaching(0.3, {})), 0.0);
  EXPECT_EQ(penalty_of(reaching(0.99 * kAlone, {})), 0.0);
}

TEST(TrunkTravel, WithinTheArmsReachAnyWayOfTheShoulderCosts) {
  for (const Vec3d& moved : {Vec3d{0, 0, 0.1}, Vec3d{0, 0, -0.1}, Vec3d{0.1, 0, 0},
                             Vec3d{0, -0.1, 0}, Vec3d{0, 0.06, 0.08}}) {
    EXPECT_NEAR(penalty_of(reaching(0.3, moved)), cost_of(0.1), 1e-12);
  }
}

TEST(TrunkTravel, BeyondTheArmTheTrunkGoesAlongByWhatItLacks) {
  EXPECT_NEAR(penalty_of(reaching(kAlone + 0.15, {0, 0, 0.15})), 0.0, 1e-12);
  EXPECT_NEAR(penalty_of(reaching(kAlone + 0.15, {0, 0, 0.25})), cost_of(0.1), 1e-12);
}

TEST(TrunkTravel, AnArmThatIsStretchedOutToSpareTheTrunkCosts) {
  EXPECT_NEAR(penalty_of(reaching(kPosedArm, {})), cost_of(kPosedArm - kAlone), 1e-12);
}

TEST(TrunkTravel, OnlyTheEndCounts) {
  std::vector<Pose> poses = reaching(0.3, {});
  poses.insert(poses.begin() + 1, reaching(0.3, {0, 0, 0.5})[1]);
  EXPECT_EQ(penalty_of(poses), 0.0);
}

TEST(TrunkTravel, IsTheMeanOverTheHands) {
  std::vector<Pose> poses = reaching(0.3, {0, 0, 0.1});
  EXPECT_NEAR(penalty_of_poses<TrunkTravel>(poses), 0.5 * cost_of(0.1), 1e-12);
  poses[1].left.shoulder.y += 0.1;
  EXPECT_NEAR(penalty_of_poses<TrunkTravel>(poses), cost_of(0.1), 1e-12);
}

TEST(TrunkTravel, IsFullAtItsDistanceAndBeyond) {
  EXPECT_NEAR(penalty_of(reaching(0.3, {0, 0, kTravelDistance})), 1.0, 1e-12);
  EXPECT_EQ(penalty_of(reaching(0.3, {0, 0, 2.0 * kTravelDistance})), 1.0);
}

TEST(TrunkTravel, DistanceIsASetting) {
  EXPECT_NEAR(penalty_of(reaching(0.3, {0, 0, 0.1}), 0.4), 0.0625, 1e-12);
}

TEST(TrunkTravel, IsTheSameInAMirror) {
  std::vector<Pose> poses = lopsided_poses();
  const double penalty = penalty_of_poses<TrunkTravel>(poses);
  EXPECT_GT(penalty, 0.0);
  EXPECT_LT(penalty, 1.0);
  for (Pose& pose : poses) pose = mirrored(pose);
  EXPECT_DOUBLE_EQ(penalty_of_poses<TrunkTravel>(poses), penalty);
}

TEST(TrunkTravel, OfABodyWithoutHandsIsZero) {
  BodyDefinition handless = posed_definition();
  handless.effectors.clear();
  const BodyModel body(handless);
  TrunkTravel<double> travel(body);
  const std::vector<double> angles = angles_of(body, {.lean = 1.0});
  const Kinematics<double> start = start_kinematics(body);
  const Kinematics<double> end = placed(body, angles);
  travel.add(PlacedFrame<double>{{.angles = body.start(), .torques = {}}, start});
  travel.add(PlacedFrame<double>{{.angles = angles, .torques = {}}, end});
  EXPECT_EQ(travel.penalty(), 0.0);
}

TEST(TrunkTravel, ForgetsWhatItSaw) {
  TrunkTravel<double> travel(posed_body(), {.effectors = right_hand_of(posed_body())});
  show_poses(posed_body(), reaching(0.3, {0, 0, 0.1}), travel);
  EXPECT_GT(travel.penalty(), 0.0);
  travel.reset();
  EXPECT_EQ(travel.penalty(), 0.0);
  // the way begins anew
  show_poses(posed_body(), {reaching(0.3, {0, 0, 0.1})[1]}, travel);
  EXPECT_EQ(travel.penalty(), 0.0);
}

TEST(TrunkTravel, OfNoFramesIsZero) { EXPECT_EQ(penalty_of({}), 0.0); }

TEST(GoalHands, AreTheHandsOfTheGoalsOrAll) {
  const BodyModel body = human_body();
  EXPECT_EQ(goal_hands(body, {}).size(), 2u);
  EXPECT_EQ(goal_hands(body, right_hand_of(body)).size(), 1u);
  EXPECT_EQ(goal_hands(half_body(), {}).size(), 1u);
  // goals of a head, a foot or an elbow are not of a hand
  for (const char* other : {"head", "left_foot", "right_elbow"}) {
    EXPECT_EQ(goal_hands(body, {body.find_effector(other).value()}).size(), 0u) << other;
  }
}

TEST(GoalHands, ArmsAreAsLongAsTheyReachStretchedOut) {
  for (const BodyModel& body : {half_body(), full_body(), human_body()}) {
    std::vector<double> straight(body.start().begin(), body.start().end());
    for (int d = 0; d < body.dof_count(); ++d) {
      const std::string& joint = body.dof(d).part.joint;
      if (joint == "elbow" || joint == "wrist") straight[static_cast<std::size_t>(d)] = 0.0;
    }
    const Kinematics<double> kinematics = placed(body, straight);
    for (const GoalHand& goal : goal_hands(body, {})) {
      const Vec3d arm = goal.hand.in(kinematics)-goal.shoulder.in(kinematics);
      // the grip lies off the forearm's line by a little
      EXPECT_NEAR(goal.arm, norm(arm), 0.01) << body.name();
      EXPECT_GE(goal.arm, norm(arm) - 1e-12) << body.name();
    }
  }
}

}  // namespace
}  // namespace shigusa
