// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math/vec3.hpp>
#include <span>

namespace shigusa {

// One frame of a motion as the built-in criteria see it. They look at frames one after the other
// and keep sums, so a search stores no motion.
template <class S>
struct MotionFrame {
  std::span<const S> angles;   // (dofs) rad
  std::span<const S> torques;  // (dofs) N·m
  Vec3<S> centre_of_mass{};    // m, world
};

}  // namespace shigusa
