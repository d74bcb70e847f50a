// SPDX-License-Identifier: MIT
#include "criteria/coordination.hpp"

#include <gtest/gtest.h>

#include "human/at_ease.hpp"
#include "support/motions.hpp"
#include "support/penalty_by.hpp"
#include "support/posed_body.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kLean = radians(50);
constexpr double kOff = 0.1;  // rad

// People's knee flexion (rad) at a lean, with the hands that far ahead of the ankles (in
// kHandAhead).
double peoples_knees(double lean, double far) {
  return Habit{}.knees * (kKneesNear + (1.0 - kKneesNear) * far) * lean * lean /
         (lean + kKneesBegin);
}

// A posture of people's proportions, with the hands that far ahead of the ankles (in kHandAhead).
Pose peoples(double lean, double far = 1.0) {
  Pose pose{.lean = lean};
  pose.left_knee = pose.right_knee = peoples_knees(lean, far);
  pose.left.hand.z = pose.right.hand.z = kPosedAnkles.z + far * kHandAhead * kPosedStature;
  return pose;
}

Pose with_knees(Pose pose, double flexion) {
  pose.left_knee = pose.right_knee = flexion;
  return pose;
}

double penalty_of(const Pose& pose, const Asked& asked = {}) {
  return penalty_of_poses<Coordination>({pose}, asked);
}

// The penalty of knees with that error (rad).
double cost_of(double off, double angle = kCoordinationAngle) {
  const double squares = 0.25 * off * off / (angle * angle);
  return squares / (1.0 + squares);
}

TEST(Coordination, OfUprightStandingIsZero) { EXPECT_EQ(penalty_of({}), 0.0); }

TEST(Coordination, OfPeoplesProportionsIsZero) {
  for (const double lean : {radians(5), radians(30), radians(60), radians(100)}) {
    for (const double far : {0.0, 0.5, 1.0})
      EXPECT_NEAR(penalty_of(peoples(lean, far)), 0.0, 1e-12);
  }
}

TEST(Coordination, KneesMayBendTooMuchOrTooLittle) {
  for (const double off : {kOff, -kOff}) {
    const Pose pose = with_knees(peoples(kLean), peoples_knees(kLean, 1.0) + off);
    EXPECT_NEAR(penalty_of(pose), cost_of(off), 1e-12);
  }
}

TEST(Coordination, KneesAreThoseOfTheHabit) {
  const Pose pose = with_knees(peoples(kLean), 2.0 * peoples_knees(kLean, 1.0));
  EXPECT_GT(penalty_of(pose), 0.3);
  EXPECT_NEAR(penalty_of(pose, {.habit = {.knees = 2.0 * Habit{}.knees}}), 0.0, 1e-12);
}

TEST(Coordination, FadesForHandsAtTablesAndAbove) {
  Pose pose = with_knees(peoples(kLean), 0.0);
  double before = 1.0;
  for (const double height : {0.3, kKneesUpTo + 0.05, kKneesUpTo + 0.1, kKneesNoMore, 0.8}) {
    pose.left.hand.y = pose.right.hand.y = kPosedAnkles.y + height * kPosedStature;
    const double now = penalty_of(pose);
    EXPECT_LE(now, before) << height;
    before = now;
  }
  EXPECT_EQ(before, 0.0);
}

TEST(Coordination, KneesAreTheMeanOfBoth) {
  Pose pose = peoples(kLean);
  pose.left_knee += kOff;
  pose.right_knee -= kOff;
  EXPECT_NEAR(penalty_of(pose), 0.0, 1e-12);
}

TEST(Coordination, WhoeverLeansOnStraightKneesPays) {
  constexpr double kLittle = radians(20);
  EXPECT_NEAR(penalty_of(with_knees(peoples(kLittle), 0.0)), cost_of(peoples_knees(kLittle, 1.0)),
              1e-12);
}

TEST(Coordination, WhoeverBendsTheKneesUnderAnUprightTrunkPays) {
  EXPECT_NEAR(penalty_of(with_knees({}, kOff)), cost_of(kOff), 1e-12);
}

TEST(Coordination, KneesBendLessForANearHand) {
  constexpr double kLittle = radians(20);
  double before = 1.0;
  for (const double far : {1.0, 0.6, 0.3, 0.0}) {
    const double now = penalty_of(with_knees(peoples(kLittle, far), 0.0));
    EXPECT_LT(now, before);
    before = now;
  }
}

TEST(Coordination, FartherThanPeopleLikeItChangesNothing) {
  Pose pose = peoples(kLean, 1.0);
  pose.left.hand.z += 0.5;
  pose.right.hand.z += 0.5;
  EXPECT_NEAR(penalty_of(pose), 0.0, 1e-12);
}

TEST(Coordination, HandsBesideOrBehindAreAsFarAsThoseAhead) {
  constexpr double kFar = 0.4;
  const double way = kFar * kHandAhead * kPosedStature;
  for (const Vec3d& to :
       {Vec3d{way, 0, 0}, Vec3d{-way, 0, 0}, Vec3d{0, 0, -way}, Vec3d{0.6 * way, 0, 0.8 * way}}) {
    Pose pose = peoples(kLean, kFar);
    for (Vec3d* hand : {&pose.left.hand, &pose.right.hand}) {
      hand->x = kPosedAnkles.x + to.x;
      hand->z = kPosedAnkles.z + to.z;
    }
    EXPECT_NEAR(penalty_of(pose), 0.0, 1e-12);
  }
}

TEST(Coordination, LooksAtTheHandsOfTheGoals) {
  Pose pose = peoples(kLean, 1.0);
  pose.left.hand.z = -1.0;
  const std::vector<int> right = right_hand_of(posed_body());
  EXPECT_NEAR(penalty_of(pose, {.effectors = right}), 0.0, 1e-12);
  EXPECT_GT(penalty_of(pose), 0.0);
}

TEST(Coordination, ALeanBackwardsIsNone) {
  EXPECT_EQ(penalty_of({.lean = -0.3}), 0.0);
  EXPECT_NEAR(penalty_of(with_knees({.lean = -0.3}, kOff)), cost_of(kOff), 1e-12);
}

TEST(Coordination, OnlyTheEndCounts) {
  Pose other = peoples(kLean);
  other.left_knee = 2.0;
  EXPECT_NEAR(penalty_of_poses<Coordination>({other, peoples(kLean)}), 0.0, 1e-12);
}

TEST(Coordination, NearerIsBetterHoweverFarItIs) {
  double before = -1.0;
  for (double knees = 0.0; knees < 6.0 * kCoordinationAngle; knees += 0.1) {
    const double now = penalty_of(with_knees({}, knees));
    EXPECT_GT(now, before);
    EXPECT_LT(now, 1.0);
    before = now;
  }
}

TEST(Coordination, AngleIsASetting) {
  EXPECT_NEAR(penalty_of(with_knees({}, kOff), {.scale = 0.2}), cost_of(kOff, 0.2), 1e-12);
}

TEST(Coordination, IsTheSameInAMirror) { expect_the_same_in_a_mirror<Coordination>(); }

TEST(Coordination, OfABodyWithoutKneesHipsOrShouldersIsZero) {
  const Pose pose = with_knees(peoples(kLean), 2.0);
  ASSERT_GT(penalty_of(pose), 0.0);
  for (const std::vector<std::string>& lacks : {std::vector<std::string>{"left_knee", "right_knee"},
                                                {"left_upper_leg"},
                                                {"right_upper_arm"},
                                                {"left_foot"}}) {
    EXPECT_EQ(penalty_of_poses<Coordination>({pose}, {}, posed_body_without(lacks)), 0.0)
        << lacks[0];
  }
}

// The half body's left side is a stub, and a seated person's legs are one piece.
TEST(Coordination, OfAHalfBodyAndOfWhoSitsIsZero) {
  const Landmarks person = standing_landmarks(1.7, kStandingToeOut);
  const PosedBody sits = build_human(
      seated(person, 1.7, 0.42),
      {.name = "s", .extent = BodyExtent::human, .stature = 1.7, .mass = 70.0, .sits = true});
  Random random(3);
  for (const PosedBody& posed : {half_body(), sits}) {
    const Motion motion = motion_through(posed, {random_posture(posed, random)});
    EXPECT_EQ(penalty_by<Coordination>(posed, motion), 0.0) << posed.body.name();
  }
}

}  // namespace
}  // namespace shigusa
