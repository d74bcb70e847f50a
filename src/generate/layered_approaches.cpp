// SPDX-License-Identifier: MIT
#include "layered_approaches.hpp"

#include <array>
#include <utility>

#include "approaches.hpp"

namespace shigusa {
namespace {

RolledOut play_layers(const LayeredProblem& problem, const Parameters& parameters) {
  LayeredPlayer player(problem);
  ReducedClip clip;
  player.run_upper(parameters, clip);
  return player.expand(clip, parameters);
}

// The weights that layers give to the whole body's freedoms; what they move in closed form has
// weights of 1.
Parameters body_parameters(const LayeredProblem& problem, const Parameters& layered) {
  const BodyModel& body = *problem.reach.body;
  Parameters parameters = uniform_parameters(body);
  const auto set = [&](int dof, const JointWeight& joint) {
    parameters.joints[static_cast<std::size_t>(dof)] = joint;
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

std::optional<Arrival> LayeredApproaches::body_arrival(const Parameters& parameters) const {
  return first_arrival(problem_->body_approaches, body_parameters(*problem_, parameters));
}

std::optional<Arrival> LayeredApproaches::arrival(const Parameters& parameters,
                                                  LayeredApproach last) const {
  if (problem_->in_reach) {
    RolledOut rolled = play_layers(*problem_, parameters);
    if (rolled.outcome.met(problem_->reach.tolerance)) {
      return Arrival{&problem_->reach, std::move(rolled)};
    }
  }
  return last == LayeredApproach::layers ? std::nullopt : body_arrival(parameters);
}

Arrival LayeredApproaches::any_arrival(const Parameters& parameters) const {
  if (auto arrived = arrival(parameters, LayeredApproach::body)) return std::move(*arrived);
  return nearest_arrival(problem_->body_approaches, body_parameters(*problem_, parameters));
}

}  // namespace shigusa
