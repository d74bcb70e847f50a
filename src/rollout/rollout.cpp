// SPDX-License-Identifier: MIT
#include <shigusa/rollout/rollout.hpp>

#include "record_motion.hpp"

namespace shigusa {

std::vector<IkTarget<double>> ik_targets(const ReachProblem& problem) {
  const BodyModel& body = *problem.body;
  Kinematics<double> kinematics(body);
  forward_kinematics<double>(body, body.start(), kinematics);
  std::vector<IkTarget<double>> targets;
  for (const ReachGoal& goal : problem.goals) {
    const Effector& effector = body.effectors()[static_cast<std::size_t>(goal.effector)];
    targets.push_back({.link = effector.link, .point = effector.point, .position = goal.path.goal});
  }
  for (const Foot& foot : body.feet()) {
    if (foot.link == kBaseLink) continue;
    targets.push_back({.link = foot.link,
                       .point = foot.centre,
                       .position = kinematics.point(foot.link, foot.centre),
                       .contact = true,
                       .orientation = kinematics.link_rotation(foot.link)});
  }
  return targets;
}

RolledOut roll_out(const ReachProblem& problem, const Parameters& parameters) {
  return record_motion(problem, parameters, Rollout<double>(problem));
}

}  // namespace shigusa
