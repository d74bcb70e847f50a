// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "plan/held_input.hpp"
#include "rollout/rollout.hpp"
#include "support/problems.hpp"

// The criteria evaluate a motion twice: frame by frame while it is made, and again as a stored one.
namespace shigusa {
namespace {

using namespace testing_support;

CriteriaSettings every_criterion() {
  CriteriaSettings settings;
  for (CriterionSetting& setting : settings.built_in) setting.weight = 1.0;
  return settings;
}

TEST(ScoredFrames, OfARolloutAndOfItsStoredMotionAgree) {
  for (const PosedBody& posed : {half_body(), full_body()}) {
    for (const Vec3d& goal : {Vec3d{0.25, 0.55, 0.5}, Vec3d{-0.3, 1.8, 0.3}}) {
      ReachProblem problem = reach_with(posed, "right_hand", goal);
      problem.duration = 1.3;
      problem.context.gaze = goal;
      const CriteriaSettings settings = every_criterion();
      BuiltInCriteria<double> criteria(posed, problem.context, settings);
      Rollout<double> rollout(problem);
      Random random(71);
      for (int trial = 0; trial < 20; ++trial) {
        const Parameters parameters = random_parameters(posed, random);
        criteria.reset();
        rollout.run(inverse_weights(posed, parameters),
                    [&](const PlacedFrame<double>& frame) { criteria.add(frame); });
        const Score stored =
            score_motion(posed, roll_out(problem, parameters).motion, settings, problem.context);
        std::size_t term = 0;
        criteria.visit_penalties([&](std::string_view name, double weight, double penalty) {
          ASSERT_LT(term, stored.terms.size());
          EXPECT_EQ(stored.terms[term].name, name);
          EXPECT_EQ(stored.terms[term].weight, weight);
          // the stored frame time is rounded once, its inverse once more
          EXPECT_NEAR(stored.terms[term].penalty, penalty, 1e-13) << name;
          ++term;
        });
        EXPECT_EQ(term, std::tuple_size_v<decltype(kCriteria)>);
      }
    }
  }
}

TEST(ScoredFrames, HaveThePlacementOfTheirAngles) {
  const PosedBody posed = full_body();
  const ReachProblem problem = reach_with(posed, "right_hand", {0.25, 0.55, 0.5});
  const std::vector<double> inverse = inverse_weights(posed, uniform_parameters(posed));
  Rollout<double> rollout(problem);
  rollout.run(inverse, [&](const PlacedFrame<double>& frame) {
    const Kinematics<double> again = placed(posed, frame.angles);
    for (std::size_t d = 0; d < again.origin.size(); ++d) {
      EXPECT_EQ(again.origin[d], frame.kinematics.origin[d]);
    }
    EXPECT_DOUBLE_EQ(frame.frame_time, problem.duration / problem.steps);
  });
}

TEST(ScoredFrames, HaveTheSpeedsOfTheirAngles) {
  const PosedBody posed = half_body();
  ReachProblem problem = reach_with(posed, "right_hand", {0.25, 0.55, 0.5});
  problem.duration = 0.8;
  const Clip clip = roll_out(problem, uniform_parameters(posed)).motion.clip;
  Rollout<double> rollout(problem);
  int f = 0;
  rollout.run(
      inverse_weights(posed, uniform_parameters(posed)), [&](const PlacedFrame<double>& frame) {
        const int last = clip.frames - 1;
        for (std::size_t d = 0; d < frame.angles.size(); ++d) {
          const double before = clip.frame(f > 0 ? f - 1 : 0)[d];
          const double after = clip.frame(f < last ? f + 1 : last)[d];
          const double now = clip.frame(f)[d];
          const double rate = last / 0.8;
          EXPECT_NEAR(frame.speeds[d], (after - before) * rate / 2, 1e-11);
          EXPECT_NEAR(frame.accelerations[d], (after - 2 * now + before) * rate * rate, 1e-9);
        }
        ++f;
      });
  EXPECT_EQ(f, clip.frames);
}

}  // namespace
}  // namespace shigusa
