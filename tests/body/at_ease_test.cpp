// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/body/anthropometry.hpp>
#include <shigusa/body/at_ease.hpp>
#include <shigusa/body/human_body.hpp>

namespace shigusa {
namespace {

constexpr double kRounding = 1e-12;

// A person in a T with straight legs, one hand bent and holding.
Landmarks t_pose() {
  Landmarks person = standing_landmarks(1.7, 0.0);
  for (const double side : {1.0, -1.0}) {
    Landmarks::Leg& leg = side > 0 ? person.left_leg : person.right_leg;
    leg.knee = {leg.ankle.x, leg.ankle.y + 0.42, leg.ankle.z};
    leg.hip = {leg.ankle.x, leg.ankle.y + 0.83, leg.ankle.z};
    Landmarks::Arm& arm = side > 0 ? person.left_arm : person.right_arm;
    arm.elbow = arm.shoulder + Vec3d{side * 0.3, 0, 0};
    arm.wrist = arm.elbow + Vec3d{side * 0.25, 0, 0};
    arm.fingertip = arm.wrist + Vec3d{side * 0.17, 0, 0.05};
    arm.grip = arm.wrist + Vec3d{side * 0.08, -0.01, 0.02};
  }
  return person;
}

double knee_angle(const Landmarks::Leg& leg) {
  const Vec3d thigh = leg.knee - leg.hip;
  const Vec3d shank = leg.ankle - leg.knee;
  return atan2(norm(cross(thigh, shank)), dot(thigh, shank));
}

TEST(AtEase, StraightKneesBendForwardsOverFeetThatStay) {
  const Landmarks before = t_pose();
  const Landmarks after = at_ease(before, 1.7);
  for (const Side side : {Side::left, Side::right}) {
    const Landmarks::Leg& leg = after.leg(side);
    EXPECT_EQ(leg.ankle, before.leg(side).ankle);
    EXPECT_EQ(leg.toe, before.leg(side).toe);
    EXPECT_NEAR(knee_angle(leg), kKneesAtEase, 1e-9);
    EXPECT_GT(leg.knee.z, leg.ankle.z);
    EXPECT_NEAR(norm(leg.hip - leg.knee), 0.41, kRounding);
    EXPECT_NEAR(norm(leg.knee - leg.ankle), 0.42, kRounding);
  }
}

TEST(AtEase, TheTrunkComesDownAsOne) {
  const Landmarks before = t_pose();
  const Landmarks after = at_ease(before, 1.7);
  const Vec3d down = after.left_leg.hip - before.left_leg.hip;
  EXPECT_LT(down.y, 0.0);
  EXPECT_EQ(down.x, 0.0);
  EXPECT_EQ(down.z, 0.0);
  EXPECT_LE(norm(after.right_leg.hip - before.right_leg.hip - down), kRounding);
  EXPECT_LE(norm(after.right_arm.shoulder - before.right_arm.shoulder - down), kRounding);
  EXPECT_LE(norm(after.neck - before.neck - down), kRounding);
  EXPECT_LE(norm(after.head_top - before.head_top - down), kRounding);
}

TEST(AtEase, BentKneesStay) {
  Landmarks before = t_pose();
  for (Landmarks::Leg* leg : {&before.left_leg, &before.right_leg}) leg->knee.z += 0.06;
  ASSERT_GT(knee_angle(before.left_leg), kKneesAtEase);
  const Landmarks after = at_ease(before, 1.7);
  EXPECT_EQ(after.left_leg.hip, before.left_leg.hip);
  EXPECT_EQ(after.left_leg.knee, before.left_leg.knee);
}

TEST(AtEase, ArmsHangInTheirLengthsAndHandsStayAsTheyAreOnThem) {
  const Landmarks before = t_pose();
  const Landmarks after = at_ease(before, 1.7);
  const Landmarks::Arm& was = before.right_arm;
  const Landmarks::Arm& arm = after.right_arm;
  EXPECT_NEAR(arm.shoulder.y - arm.elbow.y, 0.3, kRounding);
  EXPECT_NEAR(norm(arm.wrist - arm.elbow), 0.25, kRounding);
  EXPECT_GT(arm.wrist.z, arm.elbow.z);
  const auto along = [](const Landmarks::Arm& a, const Vec3d& p) {
    return dot(p - a.wrist, normalized(a.wrist - a.elbow));
  };
  EXPECT_NEAR(along(arm, arm.fingertip), along(was, was.fingertip), 1e-9);
  EXPECT_NEAR(along(arm, *arm.grip), along(was, *was.grip), 1e-9);
  EXPECT_NEAR(norm(arm.fingertip - *arm.grip), norm(was.fingertip - *was.grip), 1e-9);
}

TEST(AtEase, MirroredPersonsStandMirrored) {
  const Landmarks after = at_ease(t_pose(), 1.7);
  const auto across = [](const Vec3d& p) { return Vec3d{-p.x, p.y, p.z}; };
  EXPECT_LE(norm(across(after.left_arm.fingertip) - after.right_arm.fingertip), 1e-9);
  EXPECT_LE(norm(across(after.left_leg.knee) - after.right_leg.knee), 1e-9);
}

}  // namespace
}  // namespace shigusa
