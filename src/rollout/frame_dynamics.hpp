// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "body/load.hpp"
#include "criteria/motion_frame.hpp"
#include "dynamics/contact_forces.hpp"
#include "dynamics/hand_load.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Computes a rollout's frames from its angles: velocities, accelerations, joint torques, the floor
// reaction and the centre of mass. Owns the memory that the last frame refers to.
template <class S>
class FrameDynamics {
 public:
  // The problem and its body outlive the object.
  explicit FrameDynamics(const ReachProblem& problem)
      : problem_(&problem),
        floor_(floor_height(*problem.body)),
        work_(*problem.body),
        speeds_(problem.body->dofs().size()),
        accelerations_(speeds_),
        torques_(speeds_),
        hands_(problem.supports.size()) {
    for (std::size_t k = 0; k < hands_.size(); ++k) {
      hands_[k].link = problem.body->effector(problem.supports[k].effector).link;
      hands_[k].carrier = problem.supports[k].carrier;
    }
  }

  // Begins a motion with supports. `shares` (supports): share of the body's weight borne by each
  // hand.
  void begin(std::span<const S> shares) {
    shares_ = shares;
    frame_ = 0;
  }

  // The frame of angles[1], with velocities by central differences between its neighbours angles[0]
  // and angles[2] (dofs, rad). `now`: its placement.
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
    Wrench<S> ground = inverse_dynamics<S>(body, now, {speeds_, accelerations_}, work_, torques_);
    if (!hands_.empty()) ground = pressed(now, Wrench<S>(ground));
    bear_on_feet<S>(body, now, angles[1], ground, torques_);
    const Vec3<S> centre = centre_of_mass(body, work_);
    return {{angles[1], torques_, centre, speeds_, accelerations_, 1.0 / rate},
            now,
            pressure(ground, S(floor_)),
            hands_};
  }

 private:
  // Applies the hands' forces of this frame, and returns the floor's wrench beside them.
  [[gnu::noinline]] Wrench<S> pressed(const Kinematics<S>& now, Wrench<S> ground) {
    const BodyModel& body = *problem_->body;
    const double weight = (body.mass() - heaviest_load(problem_->start())) * kGravity;
    const double tau = static_cast<double>(frame_++) / problem_->steps;
    for (std::size_t k = 0; k < hands_.size(); ++k) {
      const HandSupport& support = problem_->supports[k];
      const Effector& hand = body.effector(support.effector);
      HandLoad<S>& load = hands_[k];
      load.at = now.point(hand.link, hand.point);
      Vec3<S> normal = to_scalar<S>(support.normal);
      if (load.carrier != kWorldCarrier) normal = now.link_rotation(load.carrier) * normal;
      const Vec3<S> arm = now.origin[index(hand.limb_root)] - load.at;
      load.force = leaning_direction(normal, arm) * (shares_[k] * S(weight * support.bears(tau)));
      bear_on_hand<S>(body, now, load, ground, torques_);
    }
    return ground;
  }

  const ReachProblem* problem_;
  double floor_;  // m
  DynamicsWorkspace<S> work_;
  std::vector<S> speeds_;         // (dofs) rad/s
  std::vector<S> accelerations_;  // (dofs) rad/s²
  std::vector<S> torques_;        // (dofs) N·m
  std::vector<HandLoad<S>> hands_;
  std::span<const S> shares_{};  // (supports)
  int frame_ = 0;                // counted in motions with supports
};

}  // namespace shigusa
