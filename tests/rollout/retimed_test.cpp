// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/rollout/retimed.hpp>

#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

TEST(Retimed, InItsOwnDurationAMotionIsWhatItWas) {
  const BodyModel body = full_body();
  const ReachProblem problem = reach_with(body, "right_hand", {-0.2, 0.5, 0.5});
  const Motion motion = roll_out(problem, uniform_parameters(body)).motion;
  const Motion again = retimed(body, motion, motion.clip.duration());
  EXPECT_EQ(again.clip.angles, motion.clip.angles);
  ASSERT_EQ(again.torques.size(), motion.torques.size());
  for (std::size_t k = 0; k < motion.torques.size(); ++k) {
    // the frames' time comes out of a division anew
    EXPECT_NEAR(again.torques[k], motion.torques[k], 1e-9) << k;
  }
}

// Speeds go by 1/T and accelerations by 1/T², and so do all torques that are not gravity's.
TEST(Retimed, WhatMovingTakesGoesByTheSquareOfTheTime) {
  const BodyModel body = full_body();
  const Motion motion =
      roll_out(reach_with(body, "right_hand", {-0.2, 0.5, 0.5}), uniform_parameters(body)).motion;
  const double duration = motion.clip.duration();
  const Motion still = retimed(body, motion, 1e6);
  const Motion slow = retimed(body, motion, 3.0 * duration);
  double most = 0.0;
  // the floor's share between the feet is no linear function of the wrench: only joints above them
  const int shoulder = body.find_dof("right_shoulder.flexion").value();
  for (int f = 0; f < motion.clip.frames; ++f) {
    const auto k = static_cast<std::size_t>(f * motion.clip.dofs + shoulder);
    const double moving = motion.torques[k] - still.torques[k];
    EXPECT_NEAR(slow.torques[k], still.torques[k] + moving / 9.0, 1e-6) << f;
    most = max(most, abs(moving));
  }
  EXPECT_GT(most, 1.0);
}

}  // namespace
}  // namespace shigusa
