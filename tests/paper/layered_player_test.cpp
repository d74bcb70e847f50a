// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "generate/layered_approaches.hpp"
#include "support/layered.hpp"
#include "support/penalty_by.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// Largest excess (rad) of ankles and knees beyond their limits in a clip; 0 if there is none.
double leg_excess(const LayeredProblem& problem, const Clip& clip) {
  double most = 0.0;
  for (const BodyLimb& leg : problem.limbs.legs) {
    for (const int dof : {leg.ankle, leg.hinge}) {
      const Dof& joint = problem.reach.body->dof(dof);
      for (int f = 1; f < clip.frames; ++f) {
        const double angle = clip.frame(f)[static_cast<std::size_t>(dof)];
        most = max(most, max(angle - joint.upper, joint.lower - angle));
      }
    }
  }
  return most;
}

// Rule R4: the hand stays on its path where the pelvis leaves its range, and the score includes it.
TEST(LayeredPlayer, PelvisOutOfRangeIsPenalisedNotClipped) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    const Task task =
        with_preset(Task(posed, {.goals = {{"right_hand", {0.0, 0.3, 0.5}}}}), Preset::layers);
    const LayeredProblem problem = testing_support::make_layered_problem(task);
    LayeredPlayer player(problem);
    Random random(3);
    int outside = 0;
    for (int i = 0; i < 200; ++i) {
      std::vector<std::uint16_t> genes;
      for (std::size_t g = 0; g < problem.layers[0].parameters.size(); ++g) {
        genes.push_back(static_cast<std::uint16_t>(1 + random.below(15)));
      }
      ReducedClip<double> clip;
      player.run_upper(decode_layer_genes(problem.layers[0], genes), clip);
      const LayeredPlayer::PelvisCheck check = player.check_pelvis(clip);
      if (clip.path_error > 1e-4 || clip.foot_error > 1e-4 || !check.in_reach) continue;
      const RolledOut played =
          player.expand(clip, {.joints = {}, .arms = std::vector<ArmWeights>(1)});
      EXPECT_NEAR(leg_excess(problem, played.motion.clip), check.excess, 1e-9);
      EXPECT_LT(played.outcome.path_error, kReachTolerance);
      if (check.excess < radians(2.0)) continue;
      ++outside;
      EXPECT_GT(penalty_by<JointRange>(posed, played.motion), 0.01);
    }
    EXPECT_GE(outside, 10) << posed.body.name();
  }
}

TEST(LayeredPlayer, PathsOfTheHandsAreTheirsInTheTrunksFrame) {
  const PosedBody posed = full_body();
  const Task task = with_preset(
      Task(posed, {.goals = {{"left_hand", {0.2, 0.9, 0.45}}, {"right_hand", {-0.2, 1.1, 0.4}}}}),
      Preset::layers);
  const LayeredProblem problem = testing_support::make_layered_problem(task);
  LayeredPlayer player(problem);
  std::vector<std::uint16_t> genes(problem.layers[0].parameters.size(), 2);
  ReducedClip<double> clip;
  player.run_upper(decode_layer_genes(problem.layers[0], genes), clip);
  ASSERT_LT(clip.path_error, 1e-4);
  const std::vector<HandPath> paths = player.hand_paths(clip);
  const RolledOut played = player.expand(clip, {.joints = {}, .arms = std::vector<ArmWeights>(2)});
  for (const int f : {0, 20, 60}) {
    const Kinematics<double> at = placed(posed, played.motion.clip.frame(f));
    for (std::size_t g = 0; g < 2; ++g) {
      const BodyLimb& arm = problem.limbs.arms[static_cast<std::size_t>(problem.arms[g])];
      const Vec3d hand = played.motion.effectors[g][static_cast<std::size_t>(f)] -
                         at.origin[static_cast<std::size_t>(arm.flexion)];
      const Vec3d seen = transpose_times(at.link_rotation(problem.limbs.trunk), hand);
      EXPECT_LT(norm(seen - paths[g][static_cast<std::size_t>(f)]), 1e-4);
    }
  }
}

}  // namespace
}  // namespace shigusa
