// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/body/human_body.hpp>
#include <shigusa/kinematics/penetration.hpp>
#include <shigusa/rollout/detour.hpp>
#include <shigusa/rollout/rollout.hpp>
#include <vector>

namespace shigusa {
namespace {

ReachProblem problem_of(const BodyModel& body, const Vec3d& goal) {
  Kinematics<double> kinematics(body);
  forward_kinematics<double>(body, body.start(), kinematics);
  const Effector& hand = body.effectors()[0];
  ReachProblem problem;
  problem.body = &body;
  problem.goals = {{0, {kinematics.point(hand.link, hand.point), goal}}};
  return problem;
}

double deepest(const ReachProblem& problem) {
  const BodyModel& body = *problem.body;
  const std::vector<double> uniform = inverse_weights(uniform_parameters(body));
  double depth = -1e9;
  Rollout<double> rollout(problem);
  rollout.run(uniform, [&](const MotionFrame<double>&, const Kinematics<double>& kinematics) {
    depth = std::max(depth, limb_penetration(body, kinematics, body.effectors()[0]).depth);
  });
  return depth;
}

TEST(AddDetours, LeavesAFreePathStraight) {
  const BodyModel body = full_body();
  ReachProblem problem = problem_of(body, {-0.4, 1.2, 0.5});
  add_detours(problem);
  EXPECT_EQ(problem.goals[0].path.detour, Vec3d{});
}

TEST(AddDetours, GoesAroundTheHipToBehindTheBack) {
  const BodyModel body = full_body();
  ReachProblem problem = problem_of(body, {0.1, 1.0, -0.3});
  const double straight = deepest(problem);
  add_detours(problem);
  EXPECT_GT(straight, kDetourDepth);
  EXPECT_LT(deepest(problem), straight);
  EXPECT_LT(problem.goals[0].path.detour.x, -kDetourClearance / 2);
}

TEST(AddDetours, StillEndsAtTheGoal) {
  const BodyModel body = full_body();
  ReachProblem problem = problem_of(body, {0.1, 1.0, -0.3});
  add_detours(problem);
  EXPECT_TRUE(roll_out(problem, uniform_parameters(body)).outcome.met());
}

TEST(AddDetours, GoesAroundTheBellyToTheOtherSide) {
  const BodyModel body = full_body();
  ReachProblem problem = problem_of(body, {0.5, 1.0, 0.1});
  const double straight = deepest(problem);
  add_detours(problem);
  EXPECT_LT(deepest(problem), straight - 0.01);
}

TEST(AddDetours, HasRuleR9sClearance) { EXPECT_EQ(kDetourClearance, 0.05); }

}  // namespace
}  // namespace shigusa
