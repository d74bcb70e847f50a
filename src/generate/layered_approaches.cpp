// SPDX-License-Identifier: MIT
#include "generate/layered_approaches.hpp"

#include <array>
#include <utility>

#include "approaches.hpp"
#include "plan/plan.hpp"
#include "planner.hpp"
#include "problem/reachability.hpp"

namespace shigusa {
namespace {

RolledOut play_layers(const LayeredProblem& problem, const LayeredValues& parameters) {
  LayeredPlayer player(problem);
  ReducedClip<double> clip;
  player.run_upper(parameters, clip);
  return player.expand(clip, parameters);
}

// The whole body's weights from those of the layers; dofs solved in closed form have a weight of 1.
Parameters body_parameters(const LayeredProblem& problem, const LayeredValues& layered) {
  const BodyModel& body = *problem.reach.body;
  Parameters parameters = uniform_parameters(body);
  const auto set = [&](int dof, const JointWeight& joint) {
    parameters.values[static_cast<std::size_t>(dof)] = joint.weight;
    parameters.locked[static_cast<std::size_t>(dof)] = joint.locked;
  };
  const ReducedBody& upper = problem.layers[0].body;
  for (const ParameterInfo& info : problem.layers[0].parameters) {
    if (info.kind != ParameterKind::weight) continue;
    for (const int d : info.applies_to) {
      const auto k = static_cast<std::size_t>(d);
      if (const auto dof = body.find_dof(upper.dofs[k].name)) set(*dof, layered.joints[k]);
    }
  }
  constexpr std::array kArm{&BodyLimb::flexion, &BodyLimb::abduction, &BodyLimb::rotation,
                            &BodyLimb::hinge};
  std::size_t slot = 0;
  for (std::size_t g = 0; g < problem.arms.size(); ++g) {
    if (!searches(problem.layers[1 + g], ParameterKind::weight)) continue;
    const BodyLimb& arm = problem.limbs.arms[static_cast<std::size_t>(problem.arms[g])];
    const ArmWeights& weights = layered.arms[slot++];
    for (std::size_t k = 0; k < kArm.size(); ++k) set(arm.*kArm[k], weights[k]);
  }
  return parameters;
}

}  // namespace

LayeredProblem in_layers(const ReachProblem& reach, const Plan& plan) {
  const BodyModel& body = *reach.body;
  LayeredProblem problem{.reach = reach,
                         .in_reach = true,
                         .layers = plan,
                         .limbs = find_limbs(body, reach.start()).value(),
                         .arms = {},
                         .arm_bodies = {}};
  for (const ReachGoal& goal : problem.reach.goals) {
    for (std::size_t a = 0; a < problem.limbs.arms.size(); ++a) {
      if (problem.limbs.arms[a].effector != goal.effector) continue;
      problem.arms.push_back(static_cast<int>(a));
      const bool turning = goal.turn.kind != Turning::free;
      problem.arm_bodies.push_back(arm_body(body, reach.start(), problem.limbs.arms[a], turning));
    }
  }
  // The hand goes straight or around the body; out of reach it follows its path to the closest
  // point.
  const ReachTolerance tolerance = problem.reach.tolerance;
  const ClosestReach closest = closest_reach(problem.reach);
  problem.body_approaches = approaches_to_goal(problem.reach, closest);
  problem.reach = problem.body_approaches.front();
  problem.reach.tolerance = tolerance;
  problem.in_reach = closest.reached();
  return problem;
}

std::optional<Arrival> body_arrival(const LayeredProblem& problem,
                                    const LayeredValues& parameters) {
  return first_arrival(problem.body_approaches, body_parameters(problem, parameters));
}

std::optional<Arrival> layered_arrival(const LayeredProblem& problem,
                                       const LayeredValues& parameters, LayeredApproach last) {
  if (problem.in_reach) {
    RolledOut rolled = play_layers(problem, parameters);
    if (rolled.outcome.met(problem.reach.tolerance)) {
      return Arrival{&problem.reach, std::move(rolled)};
    }
  }
  return last == LayeredApproach::layers ? std::nullopt : body_arrival(problem, parameters);
}

Arrival nearest_layered_arrival(const LayeredProblem& problem, const LayeredValues& parameters) {
  if (auto arrived = layered_arrival(problem, parameters, LayeredApproach::body)) {
    return std::move(*arrived);
  }
  return nearest_arrival(problem.body_approaches, body_parameters(problem, parameters));
}

}  // namespace shigusa
