// SPDX-License-Identifier: MIT
#pragma once

#include "rollout/held_input.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {

// Plays the parameters' motion with a Rollout<double>, or what has its run(), and keeps it whole.
template <class Player>
[[nodiscard]] RolledOut record_motion(const ReachProblem& problem, const Parameters& parameters,
                                      Player&& player) {
  const BodyModel& body = *problem.body;
  RolledOut result;
  Motion& motion = result.motion;
  motion.clip.dofs = body.dof_count();
  motion.clip.frames = problem.steps + 1;
  motion.clip.frame_time = problem.duration / problem.steps;
  motion.effectors.resize(problem.goals.size());
  const HeldInput held(body, parameters);
  result.outcome = player.run(held.input(), [&](const PlacedFrame<double>& frame) {
    motion.clip.angles.insert(motion.clip.angles.end(), frame.angles.begin(), frame.angles.end());
    motion.torques.insert(motion.torques.end(), frame.torques.begin(), frame.torques.end());
    motion.centre_of_mass.push_back(frame.centre_of_mass);
    for (std::size_t g = 0; g < problem.goals.size(); ++g) {
      const Effector& effector = body.effector(problem.goals[g].effector);
      motion.effectors[g].push_back(frame.kinematics.point(effector.link, effector.point));
    }
  });
  return result;
}

}  // namespace shigusa
