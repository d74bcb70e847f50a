// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "dynamics/hand_load.hpp"

namespace shigusa {

// One frame of a motion as criteria see it. They look at frames one after the other and keep sums,
// so that a search stores no motion.
template <class S>
struct MotionFrame {
  std::span<const S> angles;   // (dofs) rad
  std::span<const S> torques;  // (dofs) N·m
  Vec3<S> centre_of_mass{};    // m, world
  // central differences of the angles; the motion begins and ends at rest
  std::span<const S> speeds{};         // (dofs) rad/s
  std::span<const S> accelerations{};  // (dofs) rad/s²
  double frame_time = 0.0;             // s, to the next frame
};

// The same with where the body is, and with what the floor does to it.
template <class S>
struct PlacedFrame : MotionFrame<S> {
  const Kinematics<S>& kinematics;
  Vec3<S> pressure{};                    // of the floor on the body, see pressure()
  std::span<const HandLoad<S>> hands{};  // that rest on something
};

// Whether a criterion must be shown PlacedFrames: its `add` takes no others.
template <class Criterion, class S>
inline constexpr bool looks_at_placement =
    !requires(Criterion & criterion, const MotionFrame<S>& frame) {
  criterion.add(frame);
};

}  // namespace shigusa
