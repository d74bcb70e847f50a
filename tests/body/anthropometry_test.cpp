// SPDX-License-Identifier: MIT
#include "body/anthropometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/human.hpp>
#include <shigusa/math.hpp>
#include <vector>

namespace shigusa {
namespace {

double mass_sum(const SegmentTable& t) {
  return t.head.mass + t.trunk.mass +
         2 * (t.upper_arm.mass + t.forearm.mass + t.hand.mass + t.thigh.mass + t.shank.mass +
              t.foot.mass);
}

TEST(SegmentTable, MassesAreTheWholeBody) {
  // the printed table's fractions have four digits; its women's add up to 0.9999
  EXPECT_NEAR(mass_sum(segment_table(Sex::male)), 1.0, 1e-12);
  EXPECT_NEAR(mass_sum(segment_table(Sex::female)), 0.9999, 1e-12);
}

// De Leva 1996, table 4: mass, centre of mass and the three radii of gyration, in percent.
struct Row {
  const char* name;
  SegmentParameters SegmentTable::*segment;
  double male[5];
  double female[5];
};
constexpr Row kTable4[] = {
    {"head", &SegmentTable::head, {6.94, 50.02, 30.3, 31.5, 26.1}, {6.68, 48.41, 27.1, 29.5, 26.1}},
    {"trunk",
     &SegmentTable::trunk,
     {43.46, 43.10, 38.4, 35.8, 19.7},
     {42.57, 37.82, 37.9, 36.1, 18.2}},
    {"upper_arm",
     &SegmentTable::upper_arm,
     {2.71, 57.72, 28.5, 26.9, 15.8},
     {2.55, 57.54, 27.8, 26.0, 14.8}},
    {"forearm",
     &SegmentTable::forearm,
     {1.62, 45.74, 27.6, 26.5, 12.1},
     {1.38, 45.59, 26.1, 25.7, 9.4}},
    {"hand", &SegmentTable::hand, {0.61, 36.24, 28.8, 23.5, 18.4}, {0.56, 34.27, 24.4, 20.8, 15.4}},
    {"thigh",
     &SegmentTable::thigh,
     {14.16, 40.95, 32.9, 32.9, 14.9},
     {14.78, 36.12, 36.9, 36.4, 16.2}},
    {"shank",
     &SegmentTable::shank,
     {4.33, 43.95, 25.1, 24.6, 10.2},
     {4.81, 43.52, 26.7, 26.3, 9.2}},
    {"foot", &SegmentTable::foot, {1.37, 44.15, 25.7, 24.5, 12.4}, {1.29, 40.14, 29.9, 27.9, 13.9}},
};

TEST(SegmentTable, IsDeLevasTable4) {
  for (const Row& row : kTable4) {
    for (const Sex sex : {Sex::male, Sex::female}) {
      const SegmentParameters& p = segment_table(sex).*row.segment;
      const double(&expected)[5] = sex == Sex::male ? row.male : row.female;
      EXPECT_NEAR(p.mass, expected[0] / 100, 1e-12) << row.name;
      EXPECT_NEAR(p.com, expected[1] / 100, 1e-12) << row.name;
      EXPECT_NEAR(p.r_sagittal, expected[2] / 100, 1e-12) << row.name;
      EXPECT_NEAR(p.r_transverse, expected[3] / 100, 1e-12) << row.name;
      EXPECT_NEAR(p.r_long, expected[4] / 100, 1e-12) << row.name;
    }
  }
}

TEST(SegmentTable, KnowsTheGroupsThatWereMeasured) {
  EXPECT_EQ(segment_table(Sex::male).mean_stature, 1.741);
  EXPECT_EQ(segment_table(Sex::male).mean_mass, 73.0);
  EXPECT_EQ(segment_table(Sex::female).mean_stature, 1.735);
  EXPECT_EQ(segment_table(Sex::female).mean_mass, 61.9);
}

TEST(StatureFractions, AreDrillisAndContinis) {
  using F = StatureFractions;
  EXPECT_EQ(F::kAnkleHeight, 0.039);
  EXPECT_EQ(F::kShank, 0.246);
  EXPECT_EQ(F::kThigh, 0.245);
  EXPECT_EQ(F::kShoulderHeight, 0.818);
  EXPECT_EQ(F::kUpperArm, 0.186);
  EXPECT_EQ(F::kForearm, 0.146);
  EXPECT_EQ(F::kHand, 0.108);
  EXPECT_EQ(F::kFootLength, 0.152);
  EXPECT_EQ(F::kFootBreadth, 0.055);
  EXPECT_EQ(F::kShoulderHalfBreadth, 0.129);
  // ankle, shank and thigh stack up to the knee's and the hip's height
  EXPECT_NEAR(F::kAnkleHeight + F::kShank, 0.285, 1e-12);
  EXPECT_NEAR(F::kAnkleHeight + F::kShank + F::kThigh, 0.530, 1e-12);
}

TEST(StatureFractions, HeadAndGripAreDeLevasLengths) {
  EXPECT_NEAR(StatureFractions::kHeadLength, 0.2429 / 1.741, 5e-5);
  EXPECT_NEAR(kGripFraction, 86.2 / 189.9, 5e-4);
}

void expect_limits(const JointLimits& limits, double lower_deg, double upper_deg) {
  EXPECT_NEAR(degrees(limits.lower), lower_deg, 1e-12);
  EXPECT_NEAR(degrees(limits.upper), upper_deg, 1e-12);
}

TEST(JointLimits, AreTheTables) {
  expect_limits(kAnkleFlexion, -50, 40);
  expect_limits(kKneeFlexion, 0, 145);
  expect_limits(kHipFlexion, -20, 115);
  expect_limits(kHipAbduction, -25, 45);
  expect_limits(kHipRotation, -45, 45);
  expect_limits(kElbowFlexion, 0, 150);
  expect_limits(kShoulderRotation, -70, 90);
  EXPECT_NEAR(degrees(kHipFlexionGain), 50, 1e-12);
  EXPECT_NEAR(degrees(kHipFlexionKneeFull), 60, 1e-12);
}

TEST(DefaultMass, IsTheMeanPersonsAndGrowsWithTheSquareOfStature) {
  EXPECT_DOUBLE_EQ(default_mass(1.741, Sex::male), 73.0);
  EXPECT_DOUBLE_EQ(default_mass(1.735, Sex::female), 61.9);
  EXPECT_DOUBLE_EQ(default_mass(2 * 1.741, Sex::male), 4 * 73.0);
}

class StandingLandmarks : public testing::TestWithParam<double> {
 protected:
  const double h = GetParam();
  const Landmarks person = standing_landmarks(h, radians(7));
};

TEST_P(StandingLandmarks, HaveTheLimbLengthsOfTheStature) {
  using F = StatureFractions;
  for (const Side side : {Side::left, Side::right}) {
    const Landmarks::Leg& leg = person.leg(side);
    const Landmarks::Arm& arm = person.arm(side);
    EXPECT_NEAR(norm(leg.hip - leg.knee), F::kThigh * h, 1e-12);
    EXPECT_NEAR(norm(leg.knee - leg.ankle), F::kShank * h, 1e-12);
    EXPECT_NEAR(leg.ankle.y, F::kAnkleHeight * h, 1e-12);
    EXPECT_NEAR(norm(arm.shoulder - arm.elbow), F::kUpperArm * h, 1e-12);
    EXPECT_NEAR(norm(arm.elbow - arm.wrist), F::kForearm * h, 1e-12);
    EXPECT_NEAR(norm(arm.wrist - arm.fingertip), F::kHand * h, 1e-12);
  }
}

TEST_P(StandingLandmarks, AreSymmetric) {
  const auto mirrored = [](const Vec3d& p) { return Vec3d{-p.x, p.y, p.z}; };
  EXPECT_LT(norm(mirrored(person.left_leg.knee) - person.right_leg.knee), 1e-12);
  EXPECT_LT(norm(mirrored(person.left_leg.toe) - person.right_leg.toe), 1e-12);
  EXPECT_LT(norm(mirrored(person.left_arm.fingertip) - person.right_arm.fingertip), 1e-12);
}

TEST_P(StandingLandmarks, StandAtEase) {
  // a straight person of the stature, less what the bent knees cost: 5° of them, a few millimetres
  EXPECT_LT(person.head_top.y, h);
  EXPECT_GT(person.head_top.y, 0.998 * h);
  const auto bend = [](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return std::acos(dot(b - a, c - b) / (norm(b - a) * norm(c - b)));
  };
  const Landmarks::Leg& leg = person.right_leg;
  const Landmarks::Arm& arm = person.right_arm;
  EXPECT_NEAR(degrees(bend(leg.hip, leg.knee, leg.ankle)), 5.0, 1e-9);
  EXPECT_NEAR(degrees(bend(arm.shoulder, arm.elbow, arm.wrist)), 10.0, 1e-9);
  EXPECT_GT(leg.knee.z, leg.hip.z) << "knees bend forwards";
  EXPECT_GT(arm.wrist.z, arm.elbow.z) << "elbows bend forwards";
}

TEST_P(StandingLandmarks, TurnTheFeetOut) {
  const Vec3d left = person.left_leg.toe - person.left_leg.ankle;
  EXPECT_NEAR(degrees(std::atan2(left.x, left.z)), 7.0, 1e-9);
  const Vec3d right = person.right_leg.toe - person.right_leg.ankle;
  EXPECT_NEAR(degrees(std::atan2(right.x, right.z)), -7.0, 1e-9);
}

TEST_P(StandingLandmarks, StandOnTheFloorBetweenTheFeet) {
  EXPECT_EQ(person.left_leg.toe.y, 0.0);
  EXPECT_NEAR(person.left_leg.ankle.x + person.right_leg.ankle.x, 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Statures, StandingLandmarks, testing::Values(0.5, 1.5, 1.741, 2.5));

// Written a second time, in degrees and N·m, from the sources named in anthropometry.hpp.
TEST(JointLimits, AreThoseOfTheSources) {
  struct LimitRow {
    const JointLimits* limits;
    double lower_deg, upper_deg, torque_positive, torque_negative;
  };
  const LimitRow rows[] = {
      {&kAnkleFlexion, -50, 40, 45, 150},        {&kKneeFlexion, 0, 145, 100, 230},
      {&kHipFlexion, -20, 115, 120, 220},        {&kHipAbduction, -25, 45, 110, 110},
      {&kHipRotation, -45, 45, 50, 50},          {&kShoulderFlexion, -60, 170, 80, 80},
      {&kShoulderAbduction, -40, 170, 65, 70},   {&kShoulderRotation, -70, 90, 32, 50},
      {&kElbowFlexion, 0, 150, 70, 55},          {&kFreeHipFlexion, -20, 85, 120, 220},
      {&kAnkleInversion, -15, 35, 34, 20},       {&kToesFlexion, 0, 58, 4.7, 14.2},
      {&kSpineFlexion, -25, 80, 150, 240},       {&kSpineLateral, -35, 35, 140, 140},
      {&kSpineRotation, -45, 45, 75, 75},        {&kNeckFlexion, -22.5, 22.5, 30, 52},
      {&kNeckLateral, -22.5, 22.5, 36, 36},      {&kNeckRotation, -35, 35, 15, 15},
      {&kClavicleElevation, -8, 35, 60, 60},     {&kClavicleProtraction, -20, 25, 60, 60},
      {&kFreeShoulderFlexion, -60, 160, 80, 80}, {&kFreeShoulderAbduction, -40, 145, 65, 70},
      {&kFreeShoulderRotation, -70, 60, 32, 50}, {&kForearmRotation, -80, 80, 9, 8},
      {&kWristFlexion, -70, 80, 12.2, 7.1},      {&kWristDeviation, -30, 20, 11, 9.5},
  };
  for (const LimitRow& row : rows) {
    const auto number = &row - rows;
    EXPECT_DOUBLE_EQ(row.limits->lower, radians(row.lower_deg)) << number;
    EXPECT_DOUBLE_EQ(row.limits->upper, radians(row.upper_deg)) << number;
    EXPECT_EQ(row.limits->torque_positive, row.torque_positive) << number;
    EXPECT_EQ(row.limits->torque_negative, row.torque_negative) << number;
  }
}

}  // namespace
}  // namespace shigusa
