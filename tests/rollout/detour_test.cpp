// SPDX-License-Identifier: MIT
#include "rollout/detour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>
#include <vector>

#include "kinematics/penetration.hpp"
#include "plan/held_input.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {
namespace {

ReachProblem problem_of(const PosedBody& posed, const Vec3d& goal) {
  Kinematics<double> kinematics(posed);
  forward_kinematics<double>(posed, posed.home.angles, kinematics);
  const Effector& hand = posed.body.effectors()[0];
  ReachProblem problem;
  problem.body = &posed.body;
  problem.context.start = posed.home;
  problem.goals = {{0, {kinematics.point(hand.link, hand.point), goal}}};
  return problem;
}

double deepest(const ReachProblem& problem) {
  const BodyModel& body = *problem.body;
  const std::vector<double> uniform = inverse_weights(body, uniform_parameters(body));
  double depth = -1e9;
  Rollout<double> rollout(problem);
  rollout.run(uniform, [&](const PlacedFrame<double>& frame) {
    depth = std::max(depth, limb_penetration(body, frame.kinematics, body.effectors()[0]).depth);
  });
  return depth;
}

TEST(AddDetours, LeavesAFreePathStraight) {
  const PosedBody posed = full_body();
  ReachProblem problem = problem_of(posed, {-0.4, 1.2, 0.5});
  add_detours(problem);
  EXPECT_EQ(problem.goals[0].path.detour, Vec3d{});
}

TEST(AddDetours, GoesAroundTheHipToBehindTheBack) {
  const PosedBody posed = full_body();
  ReachProblem problem = problem_of(posed, {0.05, 0.9, -0.35});
  const double straight = deepest(problem);
  add_detours(problem);
  EXPECT_GT(straight, kDetourDepth);
  EXPECT_LT(deepest(problem), straight);
  EXPECT_LT(problem.goals[0].path.detour.x, -kDetourClearance / 2);
}

TEST(AddDetours, StillEndsAtTheGoal) {
  const PosedBody posed = full_body();
  ReachProblem problem = problem_of(posed, {0.1, 1.0, -0.3});
  add_detours(problem);
  EXPECT_TRUE(roll_out(problem, uniform_parameters(posed)).outcome.met());
}

TEST(AddDetours, GoesAroundTheBellyToTheOtherSide) {
  const PosedBody posed = full_body();
  ReachProblem problem = problem_of(posed, {0.5, 1.0, 0.1});
  const double straight = deepest(problem);
  add_detours(problem);
  EXPECT_LT(deepest(problem), straight - 0.01);
}

TEST(AddDetours, NeverSwingFarOutAndAlwaysArrive) {
  // the deepest moment may come right before the end, where a via point would fling the hand away
  const PosedBody posed = full_body();
  const Parameters uniform = uniform_parameters(posed);
  Random random(111);
  int detours = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Vec3d goal{random.uniform(-1.0, 1.0), random.uniform(0.0, 2.0),
                     random.uniform(-1.0, 1.0)};
    ReachProblem problem = problem_of(posed, goal);
    if (!roll_out(problem, uniform).outcome.met()) continue;
    add_detours(problem);
    const EffectorPath& path = problem.goals[0].path;
    if (path.detour == Vec3d{}) continue;
    ++detours;
    double farthest = 0.0;
    for (double tau = 0.0; tau <= 1.0; tau += 0.01) {
      const double share = minimum_jerk_detour(tau, path.detour_peak);
      farthest = std::max(farthest, norm(path.detour) * share);
    }
    ASSERT_LT(farthest, 0.5) << trial;
    ASSERT_TRUE(roll_out(problem, uniform).outcome.met()) << trial;
  }
  EXPECT_GT(detours, 30);
}

TEST(AddDetours, HasRuleR9sClearance) { EXPECT_EQ(kDetourClearance, 0.05); }

}  // namespace
}  // namespace shigusa
