// SPDX-License-Identifier: MIT
#include "dynamics/clip_dynamics.hpp"

#include <gtest/gtest.h>

#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

class LowReach : public testing::Test {
 protected:
  // The same postures in another duration (s).
  Motion in(double duration) {
    Clip clip = motion_.clip;
    clip.frame_time = duration / (clip.frames - 1);
    return ClipDynamics(body_).completed(clip);
  }

  const PosedBody body_ = full_body();
  const ReachProblem problem_ = reach_with(body_, "right_hand", {-0.2, 0.5, 0.5});
  const Motion motion_ = roll_out(problem_, uniform_parameters(body_)).motion;
};

TEST_F(LowReach, OfARolloutTakesWhatTheRolloutFound) {
  const Motion again = in(motion_.clip.duration());
  EXPECT_EQ(again.clip.angles, motion_.clip.angles);
  ASSERT_EQ(again.torques.size(), motion_.torques.size());
  for (std::size_t k = 0; k < motion_.torques.size(); ++k) {
    // the frames' time comes out of a division anew
    EXPECT_NEAR(again.torques[k], motion_.torques[k], 1e-9) << k;
  }
}

// Speeds scale with 1/T and accelerations with 1/T², and so do all torques except gravity's.
TEST_F(LowReach, InAnotherDurationWhatMovingTakesGoesByTheSquareOfTheTime) {
  const Motion still = in(1e6);
  const Motion slow = in(3.0 * motion_.clip.duration());
  double most = 0.0;
  // the floor's share between the feet is no linear function of the wrench: only joints above them
  const int shoulder = body_.body.find_dof("right_shoulder.flexion").value();
  for (int f = 0; f < motion_.clip.frames; ++f) {
    const auto k = static_cast<std::size_t>(f * motion_.clip.dofs + shoulder);
    const double moving = motion_.torques[k] - still.torques[k];
    EXPECT_NEAR(slow.torques[k], still.torques[k] + moving / 9.0, 1e-6) << f;
    most = max(most, abs(moving));
  }
  EXPECT_GT(most, 1.0);
}

// The floor bears only the weight of a body that stands still on both feet.
TEST(HeldStart, HasTheTorquesOfAMotionThatDoesNotMove) {
  const PosedBody posed = full_body();
  Clip still;
  still.dofs = posed.body.dof_count();
  still.frames = 3;
  for (int k = 0; k < still.frames; ++k) {
    still.angles.insert(still.angles.end(), posed.home.angles.begin(), posed.home.angles.end());
  }
  const Motion whole = ClipDynamics(posed).completed(still);
  const Motion held = held_still(posed, posed.home);
  ASSERT_EQ(held.torques.size(), static_cast<std::size_t>(posed.body.dof_count()));
  for (std::size_t d = 0; d < held.torques.size(); ++d) {
    EXPECT_EQ(held.torques[d], whole.torques[held.torques.size() + d]);
  }
}

}  // namespace
}  // namespace shigusa
