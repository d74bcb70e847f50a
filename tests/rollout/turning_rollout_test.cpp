// SPDX-License-Identifier: MIT
// Goals with orientations and boxes, from parameters to motion: in double, in lanes, and their
// reachability.
#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/human.hpp>

#include "plan/held_input.hpp"
#include "problem/reachability.hpp"
#include "rollout/batch_rollout.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

ReachProblem turning(const PosedBody& posed, Turning kind) {
  ReachProblem problem = reach_with(posed, "right_hand", {-0.25, 1.0, 0.4});
  problem.hold_limits = true;
  problem.corrections = 2;
  problem.path_slack = 3e-4;
  EffectorTurn& turn = problem.goals[0].turn;
  turn.kind = kind;
  turn.start = placed(posed, posed.home.angles).link_rotation(posed.body.effector(0).link);
  // palm down, fingers ahead
  turn.goal = {{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};
  turn.axis = {1, 0, 0};
  turn.direction = {0, -1, 0};
  return problem;
}

TEST(TurningRollout, EndsTurnedAndFollowsItsPath) {
  const PosedBody posed = human_body();
  for (const Turning kind : {Turning::whole, Turning::axis}) {
    const ReachProblem problem = turning(posed, kind);
    const RolledOut rolled = roll_out(problem, uniform_parameters(posed));
    EXPECT_TRUE(rolled.outcome.met());
    const Clip& clip = rolled.motion.clip;
    const Mat3d end =
        placed(posed, clip.frame(clip.frames - 1)).link_rotation(posed.body.effector(0).link);
    EXPECT_LT(degrees(problem.goals[0].turn.miss(end)), 0.01);
    const MeasuredMotion measured(problem, clip);
    EXPECT_LE(measured.path_error, kReachTolerance);
    EXPECT_LE(measured.contact_slide, kReachTolerance);
  }
}

TEST(TurningRollout, LanesEndAsDoubleDoes) {
  const PosedBody posed = human_body();
  for (const Turning kind : {Turning::whole, Turning::axis}) {
    const ReachProblem problem = turning(posed, kind);
    Random random(5);
    constexpr std::size_t kMotions = 8;
    std::vector<Parameters> all;
    std::vector<float> inverse;
    for (std::size_t i = 0; i < kMotions; ++i) {
      all.push_back(random_parameters(posed, random));
      for (const double weight : inverse_weights(posed, all.back())) {
        inverse.push_back(static_cast<float>(weight));
      }
    }
    const CriteriaSettings criteria;
    for (const SimdSet set : usable_simd_sets()) {
      BatchRollout batch(problem, criteria, {set, 1});
      std::vector<double> scores(kMotions);
      std::vector<float> ends(kMotions * posed.body.dofs().size());
      batch.score(inverse, scores, ends);
      for (std::size_t i = 0; i < kMotions; ++i) {
        const RolledOut rolled = roll_out(problem, all[i]);
        if (!rolled.outcome.met()) continue;
        const double score = score_motion(posed, rolled.motion, criteria, problem.context).total;
        EXPECT_NEAR(scores[i], score, 1e-3) << simd_name(set) << i;
        const std::span<const double> end = rolled.motion.clip.frame(problem.steps);
        for (std::size_t d = 0; d < end.size(); ++d) {
          EXPECT_NEAR(ends[i * end.size() + d], end[d], 2e-3) << posed.body.dofs()[d].name;
        }
      }
    }
  }
}

TEST(TurningReach, CountsTheRotation) {
  const PosedBody posed = human_body();
  ReachProblem problem = turning(posed, Turning::whole);
  const ClosestReach reach = closest_reach(problem);
  EXPECT_TRUE(reach.reached());
  EXPECT_LT(degrees(problem.goals[0].turn.miss(reach.turns[0])), 0.5);
  // a pelvis can be lowered, but not be upside down above planted feet
  ReachProblem lower = reach_with(posed, "hips", {0.0, 0.8, 0.0});
  lower.hold_limits = true;
  EXPECT_TRUE(closest_reach(lower).reached());
  lower.goals[0].turn.kind = Turning::whole;
  lower.goals[0].turn.goal = rotation(Axis::x, kPi);
  const ClosestReach far = closest_reach(lower, {.starts = 4});
  EXPECT_FALSE(far.reached());
  EXPECT_GT(degrees(lower.goals[0].turn.miss(far.turns[0])), 0.5);
}

TEST(BoxedReach, EndsInTheBoxAtItsNearSide) {
  const PosedBody posed = human_body();
  ReachProblem problem = reach_with(posed, "right_hand", {-0.25, 0.9, 0.5});
  problem.hold_limits = true;
  problem.goals[0].tolerance = {0.05, 0.0, 0.1};
  const ClosestReach reach = closest_reach(problem);
  ASSERT_TRUE(reach.reached());
  const Vec3d off = reach.positions[0] - problem.goals[0].path.goal;
  EXPECT_LE(std::fabs(off.x), 0.05);
  EXPECT_NEAR(off.y, 0.0, 1e-4);
  EXPECT_LT(off.z, 0.0);
  EXPECT_GE(off.z, -0.1);
}

}  // namespace
}  // namespace shigusa
