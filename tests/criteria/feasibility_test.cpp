// SPDX-License-Identifier: MIT
#include "criteria/feasibility.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr double kStrength = 10.0;  // N·m towards larger angles, and half of it back

// A mass of 1 kg on a rod of 1 m about x, on a sole that ends 0.15 m ahead and 0.05 m behind.
PosedBody on_a_foot() {
  BodyDefinition body = chain_definition({{Axis::x, 1.0, 1.0}});
  body.dofs[0].torque_positive = kStrength;
  body.dofs[0].torque_negative = 0.5 * kStrength;
  body.feet.push_back(
      {.name = "foot",
       .node = "foot",
       .outline = {{.06, 0, .15}, {-.04, 0, .15}, {-.04, 0, -.05}, {.06, 0, -.05}}});
  return at_zero(body);
}

// The penalty of a body that stands still in the middle of its foot while its joint gives these
// torques (N·m).
Motion standing(const PosedBody& body, const std::vector<double>& torques) {
  std::vector<std::vector<double>> frames(torques.size(), {0.0});
  Motion motion = motion_through(body, frames);
  motion.torques = torques;
  return motion;
}

double penalty_of(const std::vector<double>& torques) {
  const PosedBody body = on_a_foot();
  return penalty_by<Feasibility>(body, standing(body, torques));
}

// e / (1 + e) of an excess e
double share(double excess) { return excess / (1.0 + excess); }

TEST(Feasibility, WhatIsWithinStrengthAndFeetCostsNothing) {
  EXPECT_EQ(penalty_of({0.0, kStrength, -0.5 * kStrength}), 0.0);
}

TEST(Feasibility, TheWorstMomentCounts) {
  EXPECT_NEAR(penalty_of({0.0, 1.2 * kStrength, 1.5 * kStrength, 0.0}), share(0.5), 1e-12);
  EXPECT_NEAR(penalty_of({1.5 * kStrength}), share(0.5), 1e-12);
}

TEST(Feasibility, StrengthIsThatOfTheTorquesDirection) {
  EXPECT_NEAR(penalty_of({-kStrength}), share(1.0), 1e-12);
  EXPECT_EQ(penalty_of({kStrength}), 0.0);
}

// At rest the centre of pressure is below the centre of mass.
TEST(Feasibility, PressureOutsideTheFeetCounts) {
  const PosedBody body = on_a_foot();
  const auto leaning = [&](double ahead) {
    return penalty_by<Feasibility>(body, motion_through(body, {{std::asin(ahead)}}));
  };
  EXPECT_EQ(leaning(0.14), 0.0);
  EXPECT_NEAR(leaning(0.15 + kFeasibilityOutside), 0.5, 1e-9);
  EXPECT_NEAR(leaning(-0.05 - 2.0 * kFeasibilityOutside), share(2.0), 1e-9);
}

TEST(Feasibility, LessIsBetterHoweverMuchItIs) {
  double before = 0.0;
  for (const double times : {2.0, 10.0, 100.0, 1000.0}) {
    const double penalty = penalty_of({times * kStrength});
    EXPECT_GT(penalty, before);
    EXPECT_LT(penalty, 1.0);
    before = penalty;
  }
}

}  // namespace
}  // namespace shigusa
