// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>

#include "criteria/motion_frame.hpp"
#include "dynamics/contact_forces.hpp"
#include "dynamics/hand_load.hpp"

namespace shigusa {

// Whether a criterion, or several together, need placed frames.
template <class Criteria>
[[nodiscard]] bool needs_placement(const Criteria& criteria) {
  if constexpr (requires { criteria.needs_placement(); }) {
    return criteria.needs_placement();
  } else {
    return looks_at_placement<Criteria, double>;
  }
}

// Passes a stored motion to criteria in the same way as a rollout: frame by frame, with velocities
// and accelerations by the same central differences.
template <class Criteria>
void show_motion(const BodyModel& body, const Motion& motion, Criteria& criteria) {
  const Clip& clip = motion.clip;
  const auto dofs = static_cast<std::size_t>(clip.dofs);
  const double rate = 1.0 / clip.frame_time;
  const bool placed = needs_placement(criteria);
  Kinematics<double> kinematics(body);
  DynamicsWorkspace<double> dynamics(body);
  std::vector<double> torques(dofs);
  std::vector<double> speeds(dofs);
  std::vector<double> accelerations(dofs);
  for (int f = 0; f < clip.frames; ++f) {
    const auto k = static_cast<std::size_t>(f);
    // at rest after the motion
    const std::span<const double> before = clip.frame_before(f);
    const std::span<const double> now = clip.frame(f);
    const std::span<const double> after = clip.frame(f + 1 < clip.frames ? f + 1 : f);
    for (std::size_t d = 0; d < dofs; ++d) {
      speeds[d] = (after[d] - before[d]) * (0.5 * rate);
      accelerations[d] = ((after[d] - now[d]) - (now[d] - before[d])) * (rate * rate);
    }
    const MotionFrame<double> frame{now,
                                    std::span<const double>(motion.torques).subspan(k * dofs, dofs),
                                    motion.centre_of_mass[k],
                                    speeds,
                                    accelerations,
                                    clip.frame_time};
    if (placed) {
      forward_kinematics<double>(body, now, kinematics);
      Wrench<double> ground =
          inverse_dynamics<double>(body, kinematics, {speeds, accelerations}, dynamics, torques);
      bear_on_hands(body, kinematics, motion.resting, k, ground, torques);
      criteria.add(PlacedFrame<double>{frame, kinematics, pressure(ground, floor_height(body))});
    } else if constexpr (!looks_at_placement<Criteria, double>) {
      criteria.add(frame);
    }
  }
}

}  // namespace shigusa
