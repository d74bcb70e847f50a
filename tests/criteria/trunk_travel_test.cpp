// SPDX-License-Identifier: MIT
#include "criteria/trunk_travel.hpp"

#include <gtest/gtest.h>

#include "dynamics/centre_of_mass.hpp"
#include "support/posed_body.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// Position of the body's right shoulder in the upright posture (m).
const Vec3d kHome = kPosedAnkles + Vec3d{-0.5 * kPosedShoulders, kPosedLeg + kPosedTrunk,
                                         kStandsAhead* kPosedStature};
constexpr double kAlone = kArmAlone * kPosedArm;  // m, as far as the arm reaches alone

// The right shoulder ends `moved` (m) from its home, and the hand that far (m) from there.
Pose reaching(double far, const Vec3d& moved) {
  Pose pose;
  pose.right = {kHome + moved, kHome + Vec3d{0, 0, far}};
  return pose;
}

double penalty_of(const std::vector<Pose>& poses, double distance = kTravelDistance,
                  const PosedBody& posed = posed_body()) {
  return penalty_of_poses<TrunkTravel>(
      poses, {.scale = distance, .effectors = right_hand_of(posed)}, posed);
}

// The penalty where the mean square error of shoulders is that many squares of the distance.
double penalty_for(double squares) { return squares / (1.0 + squares); }

// The penalty of a shoulder's travel that is too long, or too short, by that length (m).
double cost_of(double more) {
  return penalty_for(more * more / (kTravelDistance * kTravelDistance));
}

TEST(TrunkTravel, WithinTheArmsReachTheTrunkKeepsOut) {
  EXPECT_NEAR(penalty_of({reaching(0.3, {})}), 0.0, 1e-12);
  EXPECT_NEAR(penalty_of({reaching(0.99 * kAlone, {})}), 0.0, 1e-12);
}

TEST(TrunkTravel, WithinTheArmsReachAnyWayOfTheShoulderCosts) {
  for (const Vec3d& moved : {Vec3d{0, 0, 0.1}, Vec3d{0, 0, -0.1}, Vec3d{0.1, 0, 0},
                             Vec3d{0, -0.1, 0}, Vec3d{0, 0.06, 0.08}}) {
    EXPECT_NEAR(penalty_of({reaching(0.3, moved)}), cost_of(0.1), 1e-12);
  }
}

TEST(TrunkTravel, BeyondTheArmTheTrunkGoesAlongByWhatItLacks) {
  EXPECT_NEAR(penalty_of({reaching(kAlone + 0.15, {0, 0, 0.15})}), 0.0, 1e-12);
  EXPECT_NEAR(penalty_of({reaching(kAlone + 0.15, {0, 0, 0.25})}), cost_of(0.1), 1e-12);
}

TEST(TrunkTravel, AnArmThatIsStretchedOutToSpareTheTrunkCosts) {
  EXPECT_NEAR(penalty_of({reaching(kPosedArm, {})}), cost_of(kPosedArm - kAlone), 1e-12);
}

TEST(TrunkTravel, OnlyTheEndCounts) {
  EXPECT_NEAR(penalty_of({reaching(0.3, {0, 0, 0.5}), reaching(0.3, {})}), 0.0, 1e-12);
}

TEST(TrunkTravel, WhoStartsStoopedIsToStandUp) {
  PosedBody stooped = posed_body();
  stooped.home.angles[0] = 0.8;
  EXPECT_NEAR(penalty_of({reaching(0.3, {0, -0.1, 0})}, kTravelDistance, stooped), cost_of(0.1),
              1e-12);
}

// As of a seated body, whose legs have no joints.
TEST(TrunkTravel, ABodyWithoutKneesIsAtHomeWhereItStarts) {
  const PosedBody sits = posed_body_without({"left_knee", "right_knee"});
  const Vec3d start = kPosedAnkles + Vec3d{-0.5 * kPosedShoulders, kPosedLeg + kPosedTrunk, 0.0};
  EXPECT_NEAR(penalty_of({reaching(0.3, start - kHome)}, kTravelDistance, sits), 0.0, 1e-12);
}

TEST(TrunkTravel, IsTheMeanOverTheHands) {
  Pose pose = reaching(0.3, {0, 0, 0.1});
  pose.left = {kHome + Vec3d{kPosedShoulders, 0, 0}, kHome};
  const double squares = 0.1 * 0.1 / (kTravelDistance * kTravelDistance);
  EXPECT_NEAR(penalty_of_poses<TrunkTravel>({pose}), penalty_for(0.5 * squares), 1e-12);
  pose.left.shoulder.y += 0.1;
  EXPECT_NEAR(penalty_of_poses<TrunkTravel>({pose}), penalty_for(squares), 1e-12);
}

TEST(TrunkTravel, NearerIsBetterHoweverFarItIs) {
  double before = -1.0;
  for (double moved = 0.0; moved < 2.0; moved += 0.05) {
    const double now = penalty_of({reaching(0.3, {0, 0, moved})});
    EXPECT_GT(now, before);
    EXPECT_LT(now, 1.0);
    before = now;
  }
}

TEST(TrunkTravel, DistanceIsASetting) {
  EXPECT_NEAR(penalty_of({reaching(0.3, {0, 0, 0.1})}, 0.4), penalty_for(0.0625), 1e-12);
}

TEST(TrunkTravel, IsTheSameInAMirror) { expect_the_same_in_a_mirror<TrunkTravel>(); }

TEST(TrunkTravel, OfABodyWithoutHandsIsZero) {
  BodyDefinition handless = posed_definition();
  handless.effectors.clear();
  const PosedBody posed = at_zero(handless);
  TrunkTravel<double> travel(posed, {.start = posed.home}, kTravelDistance);
  const std::vector<double> angles = angles_of(posed, {.lean = 1.0});
  const Kinematics<double> end = placed(posed, angles);
  travel.add(PlacedFrame<double>{{.angles = angles, .torques = {}}, end});
  EXPECT_EQ(travel.penalty(), 0.0);
}

TEST(GoalHands, AreTheHandsOfTheGoalsOrAll) {
  const PosedBody posed = human_body();
  EXPECT_EQ(goal_hands(posed, {.start = posed.home}).size(), 2u);
  EXPECT_EQ(goal_hands(posed, {.start = posed.home, .effectors = right_hand_of(posed)}).size(), 1u);
  EXPECT_EQ(goal_hands(half_body(), {.start = half_body().home}).size(), 1u);
  // goals of a head, a foot or an elbow are not of a hand
  for (const char* other : {"head", "left_foot", "right_elbow"}) {
    EXPECT_EQ(goal_hands(posed, {.start = posed.home,
                                 .effectors = {posed.body.find_effector(other).value()}})
                  .size(),
              0u)
        << other;
  }
}

TEST(GoalHands, ArmsAreAsLongAsTheyReachStretchedOut) {
  for (const PosedBody& posed : {half_body(), full_body(), human_body()}) {
    std::vector<double> straight(posed.home.angles.begin(), posed.home.angles.end());
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      const std::string& joint = posed.body.dof(d).part.joint;
      if (joint == "elbow" || joint == "wrist") straight[static_cast<std::size_t>(d)] = 0.0;
    }
    const Kinematics<double> kinematics = placed(posed, straight);
    for (const GoalHand& goal : goal_hands(posed, {.start = posed.home})) {
      const Vec3d arm = goal.hand.in(kinematics)-goal.shoulder.in(kinematics);
      // the grip lies off the forearm's line by a little
      EXPECT_NEAR(goal.arm, norm(arm), 0.01) << posed.body.name();
      EXPECT_GE(goal.arm, norm(arm) - 1e-12) << posed.body.name();
    }
  }
}

// The built-in bodies start in the home positions, from which kStandsAhead and kHandHangs are
// taken.
TEST(PosturePoints, BuiltInBodiesStandAtHome) {
  for (const PosedBody& posed : {full_body(), human_body(), human_body({1.6, 60.0, Sex::female})}) {
    const PosturePoints points = posture_points(posed, posed.home);
    ASSERT_TRUE(points.found) << posed.body.name();
    const Kinematics<double> start = home_kinematics(posed);
    for (std::size_t side = 0; side < 2; ++side) {
      EXPECT_LT(norm(points.shoulders[side].in(start)-points.home_shoulders[side]), 0.02)
          << posed.body.name();
    }
    const Vec3d mass = centre_of_mass(posed, start);
    EXPECT_NEAR(mass.x, points.home_mass.x, 0.02) << posed.body.name();
    EXPECT_NEAR(mass.z, points.home_mass.z, 0.02) << posed.body.name();
    const GoalHand hand = goal_hands(posed, {.start = posed.home})[0];
    EXPECT_NEAR(hand.hand.in(start).y, points.hand_hangs, 0.05) << posed.body.name();
  }
}

}  // namespace
}  // namespace shigusa
