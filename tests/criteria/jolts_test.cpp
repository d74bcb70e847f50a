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
constexpr double kJoltOfHinge = kTorqueJolt * (kForwards + kBack);  // N·m, within kJoltTime
constexpr double kBodyWeight = 700.0;                               // N

// The penalty of a worst change of that many jolts, over the limit.
double penalty_for(double jolts) {
  const double fourth = std::pow(jolts, 4);
  return fourth / (1.0 + fourth);
}

BodyDefinition strong_hinges_definition(std::size_t count) {
  BodyDefinition body = chain_definition(std::vector<Pendulum>(count));
  for (Dof& dof : body.dofs) {
    dof.torque_positive = kForwards;
    dof.torque_negative = kBack;
  }
  return body;
}

PosedBody strong_hinges(std::size_t count) { return at_zero(strong_hinges_definition(count)); }

// A hinge on a foot.
PosedBody standing_hinge() {
  BodyDefinition body = strong_hinges_definition(1);
  body.feet.emplace_back().name = "foot";
  return at_zero(body);
}

// The penalty of these torques (frames × hinges, N·m), for a body at rest.
double penalty_of(const std::vector<double>& torques, double limit = kJoltLimit,
                  std::size_t hinges = 1, double frame_time = kJoltTime) {
  const PosedBody posed = strong_hinges(hinges);
  Motion motion = motion_through(
      posed, std::vector<std::vector<double>>(torques.size() / hinges, std::vector(hinges, 0.0)));
  motion.clip.frame_time = frame_time;
  motion.torques = torques;
  return penalty_by<Jolts>(posed, motion, limit);
}

// Passes frames with these floor pressures to the criterion, see pressure().
void show_pressures(const std::vector<Vec3d>& pressures, Jolts<double>& jolts,
                    double frame_time = kJoltTime) {
  const std::vector<double> zero{0.0};
  const Kinematics<double> kinematics = home_kinematics(standing_hinge());
  for (const Vec3d& pressure : pressures) {
    jolts.add(PlacedFrame<double>{
        {.angles = zero, .torques = zero, .frame_time = frame_time}, kinematics, pressure});
  }
}

// The floor's pressure at a place (m, with y = 0) by such a force (N).
Vec3d pressure_at(const Vec3d& place, double force = kBodyWeight) {
  return place * force + Vec3d{0, force, 0};
}

struct Floor {
  double force = kBodyWeight;     // N
  double frame_time = kJoltTime;  // s
  PosedBody posed = standing_hinge();
};

// The penalty of pressure at these places (m, with y = 0).
double penalty_at(const std::vector<Vec3d>& places, const Floor& floor = {}) {
  std::vector<Vec3d> pressures;
  for (const Vec3d& place : places) pressures.push_back(pressure_at(place, floor.force));
  Jolts<double> jolts(floor.posed, {}, kJoltLimit);
  show_pressures(pressures, jolts, floor.frame_time);
  return jolts.penalty();
}

TEST(Jolts, OfSteadyTorquesIsZeroHoweverLargeTheyAre) {
  EXPECT_EQ(penalty_of({3e3, 3e3, 3e3}), 0.0);
}

TEST(Jolts, AreHalfAtTheirShareOfTheStrengthBothWays) {
  EXPECT_NEAR(penalty_of({0.0, kJoltOfHinge}), 0.5, 1e-12);
  EXPECT_NEAR(penalty_of({10.0, 10.0 - kJoltOfHinge}), 0.5, 1e-12);
}

TEST(Jolts, AreWorseHoweverGreatTheyAre) {
  double before = 0.0;
  for (double jolts = 0.25; jolts < 20.0; jolts *= 2.0) {
    const double now = penalty_of({0.0, jolts * kJoltOfHinge});
    EXPECT_NEAR(now, penalty_for(jolts), 1e-12);
    EXPECT_GT(now, before);
    EXPECT_LT(now, 1.0);
    before = now;
  }
}

TEST(Jolts, TheGreatestChangeCounts) {
  EXPECT_NEAR(penalty_of({0.0, 0.2 * kJoltOfHinge, 0.7 * kJoltOfHinge, 0.6 * kJoltOfHinge}),
              penalty_for(0.5), 1e-12);
}

TEST(Jolts, TheWorstJointCounts) {
  EXPECT_NEAR(penalty_of({0.0, 0.0, 0.4 * kJoltOfHinge, 0.5 * kJoltOfHinge}, kJoltLimit, 2),
              penalty_for(0.5), 1e-12);
  EXPECT_NEAR(penalty_of({0.0, 0.0, -0.5 * kJoltOfHinge, 0.4 * kJoltOfHinge}, kJoltLimit, 2),
              penalty_for(0.5), 1e-12);
}

TEST(Jolts, AChangeThatIsMadeInMoreFramesIsLess) {
  EXPECT_NEAR(penalty_of({0.0, 0.25 * kJoltOfHinge, 0.5 * kJoltOfHinge}), penalty_for(0.25), 1e-12);
}

TEST(Jolts, ASteadyChangeIsTheSameInAnyFrames) {
  for (const double share : {0.25, 0.5, 2.0}) {
    const double change = 0.5 * share * kJoltOfHinge;
    EXPECT_NEAR(penalty_of({0.0, change, 2.0 * change}, kJoltLimit, 1, share * kJoltTime),
                penalty_for(0.5), 1e-12);
    const Vec3d way{0, 0, 0.5 * share * kPressureJolt};
    EXPECT_NEAR(penalty_at({{}, way, way * 2.0}, {.frame_time = share * kJoltTime}),
                penalty_for(0.5), 1e-12);
  }
}

TEST(Jolts, OfThePressureAreHalfAtTheirWay) {
  EXPECT_NEAR(penalty_at({{}, {0, 0, kPressureJolt}}), 0.5, 1e-12);
  EXPECT_NEAR(penalty_at({{}, {-kPressureJolt, 0, 0}}), 0.5, 1e-12);
  EXPECT_NEAR(penalty_at({{}, {0.3 * kPressureJolt, 0, 0.4 * kPressureJolt}}), penalty_for(0.5),
              1e-12);
}

TEST(Jolts, WherePressureStaysDoesNotMatter) {
  EXPECT_EQ(penalty_at({{0.3, 0, 0.5}, {0.3, 0, 0.5}}), 0.0);
}

TEST(Jolts, OfThePressureAreTheSameForALightBody) {
  const std::vector<Vec3d> places{{}, {0, 0, 0.6 * kPressureJolt}};
  EXPECT_NEAR(penalty_at(places, {.force = 1.0}), penalty_for(0.6), 1e-12);
  EXPECT_NEAR(penalty_at(places), penalty_for(0.6), 1e-12);
}

TEST(Jolts, ABodyWithoutFeetHasNoPressure) {
  const std::vector<Vec3d> places{{}, {0, 0, 10.0 * kPressureJolt}};
  EXPECT_GT(penalty_at(places), 0.99);
  EXPECT_EQ(penalty_at(places, {.posed = strong_hinges(1)}), 0.0);
}

// A falling body presses on nothing.
TEST(Jolts, WithoutAFloorAreANumber) {
  Jolts<double> jolts(standing_hinge(), {}, kJoltLimit);
  show_pressures({pressure_at({}), {}, {10.0, -50.0, 0}, {}}, jolts);
  EXPECT_GT(jolts.penalty(), 0.99);
  EXPECT_LE(jolts.penalty(), 1.0);
}

TEST(Jolts, LimitIsASetting) {
  EXPECT_NEAR(penalty_of({0.0, kJoltOfHinge}, 2.0), penalty_for(0.5), 1e-12);
}

TEST(Jolts, OfOneFrameAreZero) { EXPECT_EQ(penalty_of({500.0}), 0.0); }

}  // namespace
}  // namespace shigusa
