// SPDX-License-Identifier: MIT
#include "generate/layered_problem.hpp"

#include <fmt/format.h>

#include <utility>

#include "approaches.hpp"
#include "layers/plan.hpp"
#include "planner.hpp"
#include "rollout/reachability.hpp"
#include "task/make_problem.hpp"
#include "task/plan_of.hpp"

namespace shigusa {

Result<void> check_layers(const Task& task) {
  if (task.fixed) {
    return fail(
        ErrorCode::invalid_argument,
        fmt::format(
            "parameters can be fixed with the other presets; edit a result of the preset {}",
            word_of(task.preset)));
  }
  SHG_TRY(plan_of(task));
  return {};
}

Result<LayeredProblem> make_layered_problem(const Task& task) {
  SHG_TRY_ASSIGN(ReachProblem reach, make_problem(task));
  SHG_TRY_ASSIGN(Plan layers, plan_of(task));
  LayeredProblem problem{.reach = std::move(reach),
                         .in_reach = true,
                         .layers = std::move(layers),
                         .limbs = find_limbs(task.body).value(),
                         .arms = {},
                         .arm_bodies = {}};
  for (const ReachGoal& goal : problem.reach.goals) {
    for (std::size_t a = 0; a < problem.limbs.arms.size(); ++a) {
      if (problem.limbs.arms[a].effector != goal.effector) continue;
      problem.arms.push_back(static_cast<int>(a));
      const bool turning = goal.turn.kind != Turning::free;
      problem.arm_bodies.push_back(arm_body(task.body, problem.limbs.arms[a], turning));
    }
  }
  // the straight way, or around the body; out of reach, to the closest point there is, and a hand
  // keeps to its path all the same
  const ReachTolerance tolerance = problem.reach.tolerance;
  const ClosestReach closest = closest_reach(problem.reach);
  problem.body_approaches = approaches_to_goal(problem.reach, closest);
  problem.reach = problem.body_approaches.front();
  problem.reach.tolerance = tolerance;
  problem.in_reach = closest.reached();
  return problem;
}

}  // namespace shigusa
