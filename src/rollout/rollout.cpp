// SPDX-License-Identifier: MIT
#include <shigusa/rollout/rollout.hpp>

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
  const BodyModel& body = *problem.body;
  RolledOut result;
  Motion& motion = result.motion;
  motion.clip.dofs = body.dof_count();
  motion.clip.frames = problem.steps + 1;
  motion.clip.frame_time = problem.duration / problem.steps;
  motion.effectors.resize(problem.goals.size());
  Rollout<double> rollout(problem);
  const HeldInput held(body, parameters);
  result.outcome = rollout.run(held.input(), [&](const MotionFrame<double>& frame,
                                                 const Kinematics<double>& kinematics) {
    motion.clip.angles.insert(motion.clip.angles.end(), frame.angles.begin(), frame.angles.end());
    motion.torques.insert(motion.torques.end(), frame.torques.begin(), frame.torques.end());
    motion.centre_of_mass.push_back(frame.centre_of_mass);
    for (std::size_t g = 0; g < problem.goals.size(); ++g) {
      const auto index = static_cast<std::size_t>(problem.goals[g].effector);
      const Effector& effector = body.effectors()[index];
      motion.effectors[g].push_back(kinematics.point(effector.link, effector.point));
    }
  });
  return result;
}

}  // namespace shigusa
