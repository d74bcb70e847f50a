// SPDX-License-Identifier: MIT
#include "human/at_ease.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"
#include "human/landmark_points.hpp"
#include "human/moved_limbs.hpp"
#include "human/segment_mass.hpp"
#include "human/stance.hpp"
#include "kinematics/penetration.hpp"

namespace shigusa {
namespace {

constexpr double kRounding = 1e-12;

// A person in a T-pose with straight legs, and one hand bent as if holding something.
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

TEST(AtEase, TheTrunkComesDownAndAheadAsOne) {
  const Landmarks before = t_pose();
  const Landmarks after = at_ease(before, 1.7);
  const Vec3d down = after.left_leg.hip - before.left_leg.hip;
  EXPECT_LT(down.y, 0.0);
  EXPECT_EQ(down.x, 0.0);
  EXPECT_GT(down.z, 0.0);  // the mass stands over the heels before
  EXPECT_LE(norm(after.right_leg.hip - before.right_leg.hip - down), kRounding);
  EXPECT_LE(norm(after.right_arm.shoulder - before.right_arm.shoulder - down), kRounding);
  EXPECT_LE(norm(after.neck - before.neck - down), kRounding);
  EXPECT_LE(norm(after.head_top - before.head_top - down), kRounding);
}

TEST(AtEase, BentKneesStay) {
  Landmarks before = t_pose();
  // feet far enough back that the mass is over their middle
  for (Landmarks::Leg* leg : {&before.left_leg, &before.right_leg}) {
    leg->knee.z += 0.04;
    leg->ankle.z -= 0.02;
    leg->toe.z -= 0.02;
  }
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

// A person whose hips and everything above are that far (m) behind the feet.
Landmarks behind_the_feet(double back) {
  Landmarks person = t_pose();
  move_upper_body(person, {0, 0, -back});
  for (const Side side : kBothSides) person.leg(side).hip.z -= back;
  return person;
}

// 0 at the heels, 1 at the toe tips
double mass_along_soles(const Landmarks& person) {
  const SoleOutline sole = sole_outline(person.left_leg, 1.7);
  return (centre_of_mass(person, 1.7).z - sole[1].z) / (sole[0].z - sole[1].z);
}

TEST(AtEase, WhoseMassIsOverTheHeelsLeansAhead) {
  ASSERT_LT(mass_along_soles(behind_the_feet(0.06)), 0.2);
  // hands that hang lie a little ahead of where they were
  const double share = mass_along_soles(at_ease(behind_the_feet(0.06), 1.7));
  EXPECT_GT(share, 0.375);
  EXPECT_LT(share, 0.42);
  const Landmarks ahead = at_ease(behind_the_feet(-0.09), 1.7);
  EXPECT_GT(mass_along_soles(ahead), 0.5);
  EXPECT_LT(mass_along_soles(ahead), 0.58);
}

TEST(AtEase, NobodyLeansByMoreThanATwentiethOfTheStature) {
  const Landmarks before = behind_the_feet(0.3);
  const Landmarks after = at_ease(before, 1.7);
  EXPECT_NEAR(after.neck.z - before.neck.z, 0.05 * 1.7, kRounding);
  EXPECT_EQ(after.left_leg.ankle, before.left_leg.ankle);
}

// A person in a T-pose with thighs of that radius (m).
Landmarks with_thighs(double radius) {
  Landmarks person = t_pose();
  for (const BodyPart thigh : {BodyPart::left_thigh, BodyPart::right_thigh}) {
    person.parts[thigh] = {{0, 0, 0}, {0, -0.3, 0}, radius};
  }
  return person;
}

double out_of_plumb(const Landmarks::Arm& arm) {
  const Vec3d along = arm.wrist - arm.shoulder;
  return degrees(std::atan2(along.x, -along.y));
}

TEST(AtEase, ArmsGoOutwardsUntilTheyClearTheBody) {
  const double hanging = out_of_plumb(at_ease(t_pose(), 1.7).left_arm);
  EXPECT_NEAR(hanging, 0.0, 0.1);
  for (const double radius : {0.17, 0.18, 0.19, 0.2}) {
    const Landmarks person = at_ease(with_thighs(radius), 1.7);
    EXPECT_NEAR(out_of_plumb(person.right_arm), -out_of_plumb(person.left_arm), 1e-6);
    const PosedBody posed = build_human(person, {.extent = BodyExtent::human, .stature = 1.7});
    const Effector& hand = posed.body.effector(posed.body.find_effector("left_hand").value());
    const double depth = limb_penetration(posed, home_kinematics(posed), hand).depth;
    EXPECT_LE(depth, -0.005 + 1e-6) << radius;
    EXPECT_GE(depth, -0.02) << radius;  // a degree less would not do
  }
}

TEST(AtEase, ArmsGoNoFartherThanFortyDegrees) {
  const double out = out_of_plumb(at_ease(with_thighs(0.6), 1.7).left_arm);
  EXPECT_NEAR(out, 40.0, 1.5);
}

void expect_same_lengths(const Landmarks& a, const Landmarks& b) {
  for (const Side side : {Side::left, Side::right}) {
    EXPECT_NEAR(norm(a.leg(side).hip - a.leg(side).knee), norm(b.leg(side).hip - b.leg(side).knee),
                kRounding);
    EXPECT_NEAR(norm(a.leg(side).knee - a.leg(side).ankle),
                norm(b.leg(side).knee - b.leg(side).ankle), kRounding);
    EXPECT_NEAR(norm(a.arm(side).elbow - a.arm(side).wrist),
                norm(b.arm(side).elbow - b.arm(side).wrist), kRounding);
  }
  EXPECT_NEAR(norm(a.neck - a.left_arm.shoulder), norm(b.neck - b.left_arm.shoulder), kRounding);
}

TEST(Seated, HasUprightShanksOnFeetThatStayAndTheHipsOverTheSeat) {
  const Landmarks person = t_pose();
  const Landmarks sitting = seated(person, 1.7, 0.42);
  expect_same_lengths(sitting, person);
  for (const Side side : {Side::left, Side::right}) {
    const Landmarks::Leg& leg = sitting.leg(side);
    EXPECT_LT(norm(leg.ankle - person.leg(side).ankle), kRounding);
    EXPECT_LT(norm(leg.toe - person.leg(side).toe), kRounding);
    EXPECT_NEAR(leg.knee.x, leg.ankle.x, kRounding);
    EXPECT_NEAR(leg.knee.z, leg.ankle.z, kRounding);
    EXPECT_NEAR(leg.hip.y, 0.42 + kSeatedHip * 1.7, kRounding);
    EXPECT_LT(leg.hip.z, leg.ankle.z - 0.3);
  }
}

TEST(Seated, FeetHangFromAHighSeatAndGoAheadAtALowOne) {
  const Landmarks person = t_pose();
  const Landmarks high = seated(person, 1.7, 0.9);
  expect_same_lengths(high, person);
  EXPECT_GT(high.left_leg.ankle.y, person.left_leg.ankle.y + 0.1);
  EXPECT_LT(high.left_leg.knee.y, high.left_leg.hip.y);
  const Landmarks low = seated(person, 1.7, 0.0);
  expect_same_lengths(low, person);
  EXPECT_NEAR(low.left_leg.ankle.y, person.left_leg.ankle.y, kRounding);
  EXPECT_LT(low.left_leg.knee.z, low.left_leg.ankle.z);
  EXPECT_GT(low.left_leg.knee.y, low.left_leg.hip.y);
}

TEST(Seated, BodyTipsOverItsThighsAndNothingBelowMoves) {
  const Landmarks sitting = seated(standing_landmarks(1.7, kStandingToeOut), 1.7, 0.42);
  const PosedBody posed = build_human(
      sitting,
      {.name = "s", .extent = BodyExtent::human, .stature = 1.7, .mass = 70, .sits = true});
  EXPECT_EQ(posed.body.dof_count(), 39);  // 45 less two knees and ankles
  EXPECT_FALSE(posed.body.find_dof("right_knee.flexion"));
  ASSERT_EQ(posed.body.feet().size(), 2u);
  EXPECT_EQ(posed.body.feet()[0].name, "right_upper_leg");
  EXPECT_EQ(posed.body.feet()[0].link, kBaseLink);
  EXPECT_EQ(posed.body.feet()[1].name, "left_upper_leg");
  EXPECT_NEAR(posed.body.mass(), 70.0, 1e-9);
  // the soles on the floor bear too: the polygon reaches the toes
  double front = -1.0;
  for (const Vec3d& corner : posed.body.feet()[0].outline)
    front = max(front, (posed.body.base() * corner).z);
  EXPECT_NEAR(front, sitting.right_leg.toe.z, 0.02);
  const PosedBody high = build_human(
      seated(standing_landmarks(1.7, 0.0), 1.7, 1.0),
      {.name = "s", .extent = BodyExtent::human, .stature = 1.7, .mass = 70, .sits = true});
  EXPECT_EQ(high.body.feet()[0].outline.size(), 4u);
}

}  // namespace
}  // namespace shigusa
