// SPDX-License-Identifier: MIT
#include "criteria/torque.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A hinge of 100 N·m towards larger angles and 40 N·m towards smaller ones.
PosedBody strong_hinge() {
  BodyDefinition body = chain_definition({{}});
  body.dofs[0].torque_positive = 100.0;
  body.dofs[0].torque_negative = 40.0;
  return at_zero(body);
}

// The penalty of these torques (frames × dofs, N·m).
double penalty_of(const PosedBody& body, const std::vector<double>& torques,
                  double share = kTorqueShare) {
  const std::vector<double> upright(body.body.dofs().size(), 0.0);
  Motion motion = motion_through(
      body, std::vector<std::vector<double>>(torques.size() / upright.size(), upright));
  motion.torques = torques;
  return penalty_by<Torque>(body, motion, share);
}

TEST(Torque, OfRestIsZero) { EXPECT_EQ(penalty_of(strong_hinge(), {0, 0, 0}), 0.0); }

TEST(Torque, IsTheShareOfTheStrengthInItsDirection) {
  EXPECT_NEAR(penalty_of(strong_hinge(), {30}), 0.3 / 0.6, 1e-15);
  EXPECT_NEAR(penalty_of(strong_hinge(), {-12}), 0.3 / 0.6, 1e-15);
}

TEST(Torque, IsTheRootMeanSquareOverFrames) {
  EXPECT_NEAR(penalty_of(strong_hinge(), {30, 0, -12, 0}), std::sqrt(0.5 * 0.09) / 0.6, 1e-15);
}

TEST(Torque, IsTheRootMeanSquareOverJoints) {
  BodyDefinition definition = chain_definition({{}, {}});
  for (Dof& dof : definition.dofs) dof.torque_positive = dof.torque_negative = 50.0;
  EXPECT_NEAR(penalty_of(at_zero(definition), {20, -10}), std::sqrt((0.16 + 0.04) / 2) / 0.6,
              1e-15);
}

TEST(Torque, IsFullAtItsShareAndBeyond) {
  EXPECT_NEAR(penalty_of(strong_hinge(), {60}), 1.0, 1e-15);
  EXPECT_EQ(penalty_of(strong_hinge(), {1e6}), 1.0);
}

TEST(Torque, NeverFallsWithMoreTorque) {
  double before = 0.0;
  for (double tau = 0.0; tau < 100.0; tau += 1.0) {
    const double now = penalty_of(strong_hinge(), {10, tau});
    EXPECT_GE(now, before);
    before = now;
  }
}

TEST(Torque, ShareIsASetting) {
  EXPECT_NEAR(penalty_of(strong_hinge(), {30}, 0.9), 0.3 / 0.9, 1e-15);
}

}  // namespace
}  // namespace shigusa
