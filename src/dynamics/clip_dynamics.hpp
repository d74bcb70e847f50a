// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>

#include "dynamics/inverse_dynamics.hpp"

namespace shigusa {

// Computes the torques and the centre of mass of each frame of a clip, in the same way as a rollout
// of the whole body. Owns scratch memory: one per thread. The body outlives the object.
class ClipDynamics {
 public:
  explicit ClipDynamics(const BodyModel& body);

  // The motion of the clip, without effectors; `resting`: hands that rest on something meanwhile.
  [[nodiscard]] Motion completed(Clip clip, std::vector<RestingHand> resting = {});

 private:
  const BodyModel* body_;
  Kinematics<double> placed_;
  DynamicsWorkspace<double> work_;
  std::vector<double> speeds_;
  std::vector<double> accelerations_;
};

// A state held still: one frame.
[[nodiscard]] Motion held_still(const BodyModel& body, const State& state);

}  // namespace shigusa
