// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/kinematics/forward_kinematics.hpp>
#include <span>

namespace shigusa {

// One frame of a motion as the built-in criteria see it. They look at frames one after the other
// and keep sums, so a search stores no motion.
template <class S>
struct MotionFrame {
  std::span<const S> angles;   // (dofs) rad
  std::span<const S> torques;  // (dofs) N·m
  Vec3<S> centre_of_mass{};    // m, world
  // central differences of the angles; the motion begins and ends at rest
  std::span<const S> speeds{};                // (dofs) rad/s
  std::span<const S> accelerations{};         // (dofs) rad/s²
  const Kinematics<S>* kinematics = nullptr;  // the body's placement
  double frame_time = 0.0;                    // s, to the next frame
  Vec3<S> pressure{};                         // of the floor on the body, see pressure()
};

}  // namespace shigusa
