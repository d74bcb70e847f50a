// SPDX-License-Identifier: MIT
// Bending direction of knees and elbows in nearly straight limbs, or where the foot gives little
// evidence.
#include <gtest/gtest.h>

#include <shigusa/human.hpp>
#include <string>

namespace shigusa {
namespace {

double angle_of(const Landmarks& person, const char* name) {
  const PosedBody posed = build_human(person, {});
  return degrees(posed.home.angles[static_cast<std::size_t>(posed.body.find_dof(name).value())]);
}

// A person whose left thigh and shank lean back by these angles (degrees from hanging), and whose
// line from ankle to toe tip falls from level by that much.
Landmarks with_left_leg(double thigh_back, double shank_back, double toes_down) {
  Landmarks person = standing_landmarks(1.75, 0.0);
  Landmarks::Leg& leg = person.left_leg;
  const auto down = [](double back) {
    const SinCos<double> turn = sin_cos(radians(back));
    return Vec3d{0, -turn.cos, -turn.sin};
  };
  const double thigh = norm(leg.knee - leg.hip);
  const double shank = norm(leg.ankle - leg.knee);
  const double foot = norm(leg.toe - leg.ankle);
  leg.knee = leg.hip + down(thigh_back) * thigh;
  leg.ankle = leg.knee + down(shank_back) * shank;
  const SinCos<double> fall = sin_cos(radians(toes_down));
  leg.toe = leg.ankle + Vec3d{0, -fall.sin, fall.cos} * foot;
  return person;
}

TEST(HingeSides, ATrailingLegWithAHangingFootBendsAsKneesDo) {
  // a swinging leg's toes point down and back: 100° to 140° below level
  for (const double toes_down : {30.0, 80.0, 100.0, 120.0, 140.0}) {
    const Landmarks person = with_left_leg(15.0, 75.0, toes_down);
    EXPECT_NEAR(angle_of(person, "left_knee.flexion"), 60.0, 1e-9) << toes_down;
    EXPECT_NEAR(angle_of(person, "left_hip.flexion"), -15.0, 1e-9) << toes_down;
    EXPECT_NEAR(angle_of(person, "left_hip.rotation"), 0.0, 1e-9) << toes_down;
  }
}

TEST(HingeSides, AKneePastStraightStaysOnItsSide) {
  for (const double past : {1.0, 5.0, 9.0}) {
    const Landmarks person = with_left_leg(10.0, 10.0 - past, 20.0);
    EXPECT_NEAR(angle_of(person, "left_knee.flexion"), -past, 1e-9);
    EXPECT_NEAR(angle_of(person, "left_hip.rotation"), 0.0, 1e-9);
  }
}

TEST(HingeSides, AFootThatIsTurnedOutTurnsTheStraightLeg) {
  Landmarks person = with_left_leg(0.0, 0.0, 20.0);
  Landmarks::Leg& leg = person.left_leg;
  const Vec3d foot = leg.toe - leg.ankle;
  const SinCos<double> out = sin_cos(radians(25.0));
  leg.toe = leg.ankle + Vec3d{out.sin * foot.z, foot.y, out.cos * foot.z};
  EXPECT_NEAR(angle_of(person, "left_hip.rotation"), 25.0, 1e-9);
}

TEST(HingeSides, ABentElbowIsFlexedWithTheHandBehindTheBackToo) {
  Landmarks person = standing_landmarks(1.75, 0.0);
  Landmarks::Arm& arm = person.left_arm;
  const double forearm = norm(arm.wrist - arm.elbow);
  const Vec3d upper = normalized(arm.elbow - arm.shoulder);
  for (const double bend : {40.0, 70.0, 90.0, 110.0}) {
    const SinCos<double> turn = sin_cos(radians(bend));
    const Vec3d fore = upper * turn.cos + Vec3d{-0.92, 0, -0.39} * turn.sin;
    arm.wrist = arm.elbow + normalized(fore) * forearm;
    arm.fingertip = arm.wrist + normalized(fore) * 0.18;
    EXPECT_GT(angle_of(person, "left_elbow.flexion"), bend - 5.0);
  }
}

}  // namespace
}  // namespace shigusa
