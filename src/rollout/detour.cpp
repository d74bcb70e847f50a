// SPDX-License-Identifier: MIT
#include "rollout/detour.hpp"

#include "kinematics/penetration.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {
namespace {

// The deepest moment of one goal's limb during the motion of uniform weights.
struct DeepestMoment {
  Penetration deepest;  // beyond the depth in the start posture
  int frame = 0;
  bool arrives = false;  // the motion meets its goals
};

// The capsule pairs of the limb beyond the elbow: a detour of the hand does not move the upper arm.
std::vector<CapsulePair> pairs_beyond_elbow(const ReachProblem& problem, const Effector& effector) {
  const BodyModel& body = *problem.body;
  std::vector<CapsulePair> pairs =
      allowed_as_at(placed(body, problem.start()), body, limb_pairs(body, effector));
  const std::string& first = body.dof(effector.limb_root).joint;
  std::erase_if(pairs, [&](const CapsulePair& pair) {
    return body.dof(body.capsules()[index(pair.limb)].link).joint == first;
  });
  return pairs;
}

DeepestMoment find_deepest(const ReachProblem& problem, std::size_t goal) {
  const Effector& effector = problem.body->effector(problem.goals[goal].effector);
  const std::vector<double> uniform(problem.body->dofs().size(), 1.0);
  const std::vector<CapsulePair> pairs = pairs_beyond_elbow(problem, effector);
  DeepestMoment moment;
  int step = 0;
  Rollout<double> rollout(problem);
  const auto look = [&](const PlacedFrame<double>& frame) {
    const Penetration now = deepest_of(*problem.body, frame.kinematics, pairs);
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
    if (problem.goals[g].path.detour != Vec3d{}) continue;
    const DeepestMoment moment = find_deepest(problem, g);
    const bool inside = moment.frame > 0 && moment.frame < problem.steps;
    if (moment.deepest.depth <= kDetourDepth || !inside) continue;
    ReachProblem around = problem;
    EffectorPath& path = around.goals[g].path;
    path.detour = moment.deepest.outward * (moment.deepest.depth + kDetourClearance);
    const double tau = problem.tau(moment.frame);
    path.detour_peak = clamp(path.own_time(tau), kDetourMargin, 1.0 - kDetourMargin);
    // a thing goes around with all hands on it
    for (ReachGoal& other : around.goals) {
      if (!around.goals[g].carry || !other.carry) continue;
      other.path.detour = path.detour;
      other.path.detour_peak = path.detour_peak;
    }
    const DeepestMoment detoured = find_deepest(around, g);
    const bool leads_there = detoured.arrives || !moment.arrives;
    if (leads_there && detoured.deepest.depth < moment.deepest.depth) problem = around;
  }
}

}  // namespace shigusa
