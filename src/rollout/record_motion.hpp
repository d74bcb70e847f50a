// SPDX-License-Identifier: MIT
#pragma once

#include "plan/held_input.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {

// Records the frames of a motion.
class MotionRecorder {
 public:
  // The problem outlives the object.
  explicit MotionRecorder(const ReachProblem& problem) : problem_(&problem) {
    motion.clip.dofs = problem.body->dof_count();
    motion.clip.frames = problem.steps + 1;
    motion.clip.frame_time = problem.duration / problem.steps;
    const std::vector<double> momentum = problem.momentum();
    for (std::size_t d = 0; d < momentum.size(); ++d) {
      motion.clip.before.push_back(problem.start().angles[d] - momentum[d] / problem.steps);
    }
    motion.effectors.resize(problem.asked());
    for (const HandSupport& support : problem.supports) {
      motion.resting.push_back({.effector = support.effector});
      if (support.carrier != kWorldCarrier) motion.resting.back().thigh = support.carrier;
    }
  }

  void operator()(const PlacedFrame<double>& frame) {
    motion.clip.angles.insert(motion.clip.angles.end(), frame.angles.begin(), frame.angles.end());
    motion.torques.insert(motion.torques.end(), frame.torques.begin(), frame.torques.end());
    motion.centre_of_mass.push_back(frame.centre_of_mass);
    for (std::size_t g = 0; g < problem_->asked(); ++g) {
      const Effector& effector = problem_->body->effector(problem_->goals[g].effector);
      motion.effectors[g].push_back(frame.kinematics.point(effector.link, effector.point));
    }
    for (std::size_t k = 0; k < frame.hands.size(); ++k) {
      motion.resting[k].places.push_back(frame.hands[k].at);
      motion.resting[k].forces.push_back(frame.hands[k].force);
    }
  }

  Motion motion;

 private:
  const ReachProblem* problem_;
};

// Plays the parameters' motion with a Rollout<double>, or another player with the same run(), and
// records it.
template <class Player>
[[nodiscard]] RolledOut record_motion(const ReachProblem& problem, const Parameters& parameters,
                                      Player&& player) {
  MotionRecorder recorder(problem);
  const HeldInput held(*problem.body, parameters, problem.supports.size());
  const ReachOutcome outcome = player.run(held.input(), recorder);
  return {std::move(recorder.motion), outcome};
}

}  // namespace shigusa
