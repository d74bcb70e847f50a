// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <shigusa/generate/layered_problem.hpp>
#include <shigusa/layers/layered_parameters.hpp>
#include <shigusa/rollout/reachability.hpp>
#include <utility>

#include "ways.hpp"

namespace shigusa {

Result<std::vector<Layer>> layers_to_goals(const Task& task) {
  const LayerChoice choice{traits_of(task.preset).layers.value_or(LayerStack::paper),
                           task.layer_reading};
  return layers_to_goals(task.body, task.goals, choice, task_criteria(task));
}

Result<std::vector<Layer>> layers_of(const Task& task) {
  if (!task.fixed) return layers_to_goals(task);
  return fail(
      ErrorCode::invalid_argument,
      fmt::format("parameters can be fixed with the other presets; edit a result of the preset {}",
                  word_of(task.preset)));
}

Result<LayeredProblem> make_layered_problem(const Task& task) {
  Result<ReachProblem> reach = make_problem(task);
  if (!reach) return tl::unexpected(reach.error());
  Result<std::vector<Layer>> layers = layers_of(task);
  if (!layers) return tl::unexpected(layers.error());
  LayeredProblem problem{.reach = std::move(*reach),
                         .in_reach = true,
                         .layers = std::move(*layers),
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
  problem.body_ways = ways_to_goal(problem.reach, closest);
  problem.reach = problem.body_ways.front();
  problem.reach.tolerance = tolerance;
  problem.in_reach = closest.reached();
  return problem;
}

}  // namespace shigusa
