// SPDX-License-Identifier: MIT
#include "criteria/jolts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kForwards = 100.0;                                 // N·m, towards larger angles
constexpr double kBack = 40.0;                                      // N·m
constexpr double kJoltOfHinge = kTorqueJolt * (kForwards + kBack);  // N·m, from frame to frame

BodyModel strong_hinges(std::size_t count) {
  BodyDefinition body = chain_definition(std::vector<Pendulum>(count));
  for (Dof& dof : body.dofs) {
    dof.torque_positive = kForwards;
    dof.torque_negative = kBack;
  }
  return BodyModel(body);
}

// The penalty for these torques (frames × hinges, N·m) of a body that stands still.
double penalty_of(const std::vector<double>& torques, const JoltsSettings& settings = {},
                  std::size_t hinges = 1) {
  const BodyModel body = strong_hinges(hinges);
  Motion motion = motion_through(
      body, std::vector<std::vector<double>>(torques.size() / hinges, std::vector(hinges, 0.0)));
  motion.torques = torques;
  return penalty_by<Jolts>(body, motion, settings);
}

void show_pressures(const std::vector<Vec3d>& pressures, Jolts<double>& jolts) {
  const std::vector<double> zero{0.0};
  const Kinematics<double> kinematics = start_kinematics(strong_hinges(1));
  for (const Vec3d& pressure : pressures) {
    jolts.add(PlacedFrame<double>{{.angles = zero, .torques = zero}, kinematics, pressure});
  }
}

// The penalty where the floor presses at these places (m, with y = 0) by such a force (N).
double penalty_at(const std::vector<Vec3d>& places, double force = 700.0) {
  std::vector<Vec3d> pressures;
  for (const Vec3d& place : places) pressures.push_back(place * force + Vec3d{0, force, 0});
  Jolts<double> jolts(strong_hinges(1));
  show_pressures(pressures, jolts);
  return jolts.penalty();
}

TEST(Jolts, OfSteadyTorquesIsZeroHoweverLargeTheyAre) {
  EXPECT_EQ(penalty_of({3e3, 3e3, 3e3}), 0.0);
}

TEST(Jolts, AreFullAtTheirShareOfTheStrengthBothWays) {
  EXPECT_NEAR(penalty_of({0.0, kJoltOfHinge}), 1.0, 1e-12);
  EXPECT_NEAR(penalty_of({10.0, 10.0 - kJoltOfHinge}), 1.0, 1e-12);
  EXPECT_EQ(penalty_of({0.0, 1e6}), 1.0);
}

TEST(Jolts, AreTheFourthPowerOfTheGreatest) {
  EXPECT_NEAR(penalty_of({0.0, 0.5 * kJoltOfHinge}), 1.0 / 16.0, 1e-12);
  EXPECT_NEAR(penalty_of({0.0, 0.2 * kJoltOfHinge, 0.7 * kJoltOfHinge, 0.6 * kJoltOfHinge}),
              1.0 / 16.0, 1e-12);
}

TEST(Jolts, TheWorstJointCounts) {
  EXPECT_NEAR(penalty_of({0.0, 0.0, 0.4 * kJoltOfHinge, 0.5 * kJoltOfHinge}, {}, 2), 1.0 / 16.0,
              1e-12);
  EXPECT_NEAR(penalty_of({0.0, 0.0, -0.5 * kJoltOfHinge, 0.4 * kJoltOfHinge}, {}, 2), 1.0 / 16.0,
              1e-12);
}

TEST(Jolts, AChangeThatIsMadeInMoreFramesIsLess) {
  EXPECT_NEAR(penalty_of({0.0, 0.25 * kJoltOfHinge, 0.5 * kJoltOfHinge}), std::pow(0.25, 4), 1e-12);
}

TEST(Jolts, OfThePressureAreFullAtTheirWay) {
  EXPECT_NEAR(penalty_at({{}, {0, 0, kPressureJolt}}), 1.0, 1e-12);
  EXPECT_NEAR(penalty_at({{}, {-kPressureJolt, 0, 0}}), 1.0, 1e-12);
  EXPECT_NEAR(penalty_at({{}, {0.3 * kPressureJolt, 0, 0.4 * kPressureJolt}}), 1.0 / 16.0, 1e-12);
}

TEST(Jolts, WherePressureStaysDoesNotMatter) {
  EXPECT_EQ(penalty_at({{0.3, 0, 0.5}, {0.3, 0, 0.5}}), 0.0);
}

TEST(Jolts, OfThePressureAreTheSameForALightBody) {
  const std::vector<Vec3d> places{{}, {0, 0, 0.6 * kPressureJolt}};
  EXPECT_NEAR(penalty_at(places, 1.0), penalty_at(places, 700.0), 1e-12);
}

// A body that falls presses on nothing.
TEST(Jolts, WithoutAFloorAreANumber) {
  Jolts<double> jolts(strong_hinges(1));
  show_pressures({{0, 700.0, 0}, {}, {10.0, -50.0, 0}, {}}, jolts);
  EXPECT_EQ(jolts.penalty(), 1.0);
}

TEST(Jolts, LimitIsASetting) {
  EXPECT_NEAR(penalty_of({0.0, kJoltOfHinge}, {.limit = 2.0}), 1.0 / 16.0, 1e-12);
}

TEST(Jolts, OfOneFrameAreZero) { EXPECT_EQ(penalty_of({500.0}), 0.0); }

TEST(Jolts, ForgetWhatTheySaw) {
  Jolts<double> jolts(strong_hinges(1));
  show_pressures({{0, 700.0, 0}, {0, 700.0, 70.0}}, jolts);
  EXPECT_EQ(jolts.penalty(), 1.0);
  jolts.reset();
  EXPECT_EQ(jolts.penalty(), 0.0);
  // the first frame of the next motion follows on nothing
  show_pressures({{0, 700.0, 0}}, jolts);
  EXPECT_EQ(jolts.penalty(), 0.0);
}

TEST(Jolts, OfNoFramesAreZero) { EXPECT_EQ(penalty_of({}), 0.0); }

}  // namespace
}  // namespace shigusa
