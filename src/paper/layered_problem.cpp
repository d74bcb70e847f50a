// SPDX-License-Identifier: MIT
#include "paper/layered_problem.hpp"

#include <algorithm>
#include <utility>

namespace shigusa {

bool has_goal(const LayeredProblem& problem, const BodyLimb& arm) {
  return std::any_of(problem.arms.begin(), problem.arms.end(),
                     [&](int a) { return problem.limbs.arms[index(a)].effector == arm.effector; });
}

static_assert(kMotionSteps % kCoarseFrames == 0);

LayeredSetup::LayeredSetup(const LayeredProblem& of_problem)
    : problem(&of_problem),
      upper(of_problem.layers[0].body, of_problem.reach),
      start(placed(*of_problem.reach.body, of_problem.reach.start())) {
  std::size_t by_weights = 0;
  std::size_t by_swivel = 0;
  for (std::size_t g = 0; g < problem->arms.size(); ++g) {
    const PosedBody& alone_arm = problem->arm_bodies[g];
    ReachProblem& own = alone.emplace_back();
    own.body = &alone_arm.body;
    own.context.start = alone_arm.home;
    own.duration = problem->reach.duration;
    own.steps = problem->reach.steps;
    alone_coarsely.push_back(own);
    alone_coarsely.back().steps /= kCoarseFrames;
    moved.push_back(arm_dofs(arm(g), alone_arm.body.dof_count() == kTurningArmDofs));
    const bool swivels = searches(problem->layers[1 + g], ParameterKind::swivel);
    arms.push_back({swivels, swivels ? by_swivel++ : by_weights++});
  }
  for (const TrunkJoint& joint : problem->layers[0].body.joints) {
    const bool used = std::any_of(problem->arms.begin(), problem->arms.end(), [&](int number) {
      return body().moves(joint.of_body, problem->limbs.arms[index(number)].carrier);
    });
    if (used) joints.push_back(joint);
  }
  find_idle();
}

void LayeredSetup::find_idle() {
  for (const Layer& layer : problem->layers) {
    const CriterionSetting& torque = layer.criteria[CriterionKind::torque];
    IdleLoads loads{torque.weight, torque.scale, {}};
    for (const ParameterInfo& info : layer.parameters) {
      if (info.kind != ParameterKind::final_angle) continue;
      const ReducedDof& dof = layer.body.dofs[index(info.applies_to[0])];
      loads.dofs.push_back(body().find_dof(dof.name).value());
      finals.push_back({index(loads.dofs.back()), dof.start});
    }
    if (!loads.dofs.empty()) idle_loads.push_back(std::move(loads));
  }
  for (const BodyLimb& limb : problem->limbs.arms) {
    if (has_goal(*problem, limb)) continue;
    idle_arms.push_back({limb_pairs(body(), body().effectors()[index(limb.effector)])});
  }
}

LayeredSetup::~LayeredSetup() = default;

}  // namespace shigusa
