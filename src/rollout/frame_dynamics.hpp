// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "criteria/motion_frame.hpp"
#include "dynamics/contact_forces.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Makes frames of a rollout from its angles: with speeds and accelerations, what they take of the
// joints and the floor, and the centre of mass. Holds the memory that the last frame looks into.
template <class S>
class FrameDynamics {
 public:
  // The problem and its body outlive this.
  explicit FrameDynamics(const ReachProblem& problem)
      : problem_(&problem),
        floor_(floor_height(*problem.body)),
        work_(*problem.body),
        speeds_(problem.body->dofs().size()),
        accelerations_(speeds_),
        torques_(speeds_) {}

  // The frame angles[1], speeds by central differences between its neighbours angles[0] and
  // angles[2] (dofs, rad). `now`: the placement in it.
  [[nodiscard, gnu::always_inline]] PlacedFrame<S> frame(std::span<const std::vector<S>> angles,
                                                         const Kinematics<S>& now) {
    const BodyModel& body = *problem_->body;
    const double rate = problem_->steps / problem_->duration;
    const S half_rate(0.5 * rate);
    const S square_rate(rate * rate);
    for (std::size_t d = 0; d < speeds_.size(); ++d) {
      const S to_come = angles[2][d] - angles[1][d];
      const S gone = angles[1][d] - angles[0][d];
      speeds_[d] = (to_come + gone) * half_rate;
      accelerations_[d] = (to_come - gone) * square_rate;
    }
    const Wrench<S> ground =
        inverse_dynamics<S>(body, now, {speeds_, accelerations_}, work_, torques_);
    bear_on_feet<S>(body, now, angles[1], ground, torques_);
    const Vec3<S> centre = centre_of_mass(body, work_);
    return {{angles[1], torques_, centre, speeds_, accelerations_, 1.0 / rate},
            now,
            pressure(ground, S(floor_))};
  }

 private:
  const ReachProblem* problem_;
  double floor_;  // m
  DynamicsWorkspace<S> work_;
  std::vector<S> speeds_;         // (dofs) rad/s
  std::vector<S> accelerations_;  // (dofs) rad/s²
  std::vector<S> torques_;        // (dofs) N·m
};

}  // namespace shigusa
