// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/dynamics/contact_forces.hpp>
#include <shigusa/rollout/retimed.hpp>

namespace shigusa {

Motion retimed(const BodyModel& body, const Motion& motion, double duration) {
  Motion result = motion;
  Clip& clip = result.clip;
  clip.frame_time = duration / (clip.frames - 1);
  const double rate = 1.0 / clip.frame_time;
  const auto dofs = static_cast<std::size_t>(clip.dofs);
  Kinematics<double> kinematics(body);
  DynamicsWorkspace<double> dynamics(body);
  std::vector<double> speeds(dofs);
  std::vector<double> accelerations(dofs);
  for (int f = 0; f < clip.frames; ++f) {
    const auto before = clip.frame(std::max(f - 1, 0));
    const auto now = clip.frame(f);
    const auto after = clip.frame(std::min(f + 1, clip.frames - 1));
    for (std::size_t d = 0; d < dofs; ++d) {
      speeds[d] = (after[d] - before[d]) * (0.5 * rate);
      accelerations[d] = ((after[d] - now[d]) - (now[d] - before[d])) * (rate * rate);
    }
    const auto torques =
        std::span(result.torques).subspan(static_cast<std::size_t>(f) * dofs, dofs);
    forward_kinematics<double>(body, now, kinematics);
    const Wrench<double> ground =
        inverse_dynamics<double>(body, kinematics, speeds, accelerations, dynamics, torques);
    bear_on_feet<double>(body, kinematics, now, ground, torques);
  }
  return result;
}

}  // namespace shigusa
