// SPDX-License-Identifier: MIT
#include "rollout/detour.hpp"

#include "kinematics/penetration.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {
namespace {

// The deepest moment of one goal's limb during the motion of uniform weights.
struct DeepestMoment {
  double start_depth = 0.0;  // m, at the first frame
  Penetration deepest;
  int frame = 0;
  bool arrives = false;  // the motion meets its goals
};

DeepestMoment find_deepest(const ReachProblem& problem, std::size_t goal) {
  const Effector& effector = problem.body->effector(problem.goals[goal].effector);
  const std::vector<double> uniform = inverse_weights(uniform_parameters(*problem.body));
  DeepestMoment moment;
  int step = 0;
  Rollout<double> rollout(problem);
  const auto look = [&](const PlacedFrame<double>& frame) {
    const Penetration now = limb_penetration(*problem.body, frame.kinematics, effector);
    if (step == 0) moment.start_depth = now.depth;
    if (step == 0 || now.depth > moment.deepest.depth) {
      moment.deepest = now;
      moment.frame = step;
    }
    ++step;
  };
  moment.arrives = rollout.run(uniform, look).met();
  return moment;
}

}  // namespace

void add_detours(ReachProblem& problem) {
  for (std::size_t g = 0; g < problem.goals.size(); ++g) {
    const DeepestMoment moment = find_deepest(problem, g);
    const double allowed = max(moment.start_depth, 0.0) + kDetourDepth;
    const bool inside = moment.frame > 0 && moment.frame < problem.steps;
    if (moment.deepest.depth <= allowed || !inside) continue;
    ReachProblem around = problem;
    EffectorPath& path = around.goals[g].path;
    path.detour = moment.deepest.outward * (moment.deepest.depth + kDetourClearance);
    const double tau = problem.tau(moment.frame);
    path.detour_peak = clamp(path.own_time(tau), kDetourMargin, 1.0 - kDetourMargin);
    const DeepestMoment detoured = find_deepest(around, g);
    const bool leads_there = detoured.arrives || !moment.arrives;
    if (leads_there && detoured.deepest.depth < moment.deepest.depth) problem = around;
  }
}

}  // namespace shigusa
