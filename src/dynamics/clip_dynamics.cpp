// SPDX-License-Identifier: MIT
#include "dynamics/clip_dynamics.hpp"

#include <utility>

#include "dynamics/contact_forces.hpp"
#include "dynamics/hand_load.hpp"

namespace shigusa {

ClipDynamics::ClipDynamics(const BodyModel& body)
    : body_(&body),
      placed_(body),
      work_(body),
      speeds_(body.dofs().size()),
      accelerations_(body.dofs().size()) {}

Motion ClipDynamics::completed(Clip clip, std::vector<RestingHand> resting) {
  const std::size_t dofs = speeds_.size();
  const double rate = 1.0 / clip.frame_time;
  Motion motion;
  motion.torques.resize(clip.angles.size());
  for (int f = 0; f < clip.frames; ++f) {
    // central differences; at rest after the motion
    const std::span<const double> before = clip.frame_before(f);
    const std::span<const double> now = clip.frame(f);
    const std::span<const double> after = clip.frame(f + 1 < clip.frames ? f + 1 : f);
    for (std::size_t d = 0; d < dofs; ++d) {
      speeds_[d] = (after[d] - before[d]) * (0.5 * rate);
      accelerations_[d] = ((after[d] - now[d]) - (now[d] - before[d])) * (rate * rate);
    }
    forward_kinematics<double>(*body_, now, placed_);
    const std::span<double> torques =
        std::span(motion.torques).subspan(static_cast<std::size_t>(f) * dofs, dofs);
    Wrench<double> ground =
        inverse_dynamics<double>(*body_, placed_, {speeds_, accelerations_}, work_, torques);
    bear_on_hands(*body_, placed_, resting, static_cast<std::size_t>(f), ground, torques);
    bear_on_feet<double>(*body_, placed_, now, ground, torques);
    motion.centre_of_mass.push_back(centre_of_mass(*body_, work_));
  }
  motion.clip = std::move(clip);
  motion.resting = std::move(resting);
  return motion;
}

Motion held_still(const BodyModel& body, const State& state) {
  Clip clip;
  clip.dofs = body.dof_count();
  clip.frames = 1;
  clip.angles = state.angles;
  return ClipDynamics(body).completed(std::move(clip));
}

}  // namespace shigusa
