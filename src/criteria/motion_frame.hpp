// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "dynamics/hand_load.hpp"

namespace shigusa {

// One frame of a motion for the criteria, which accumulate sums frame by frame, so that a search
// stores no motion.
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

// A frame with the body's placement and the floor's reaction.
template <class S>
struct PlacedFrame : MotionFrame<S> {
  const Kinematics<S>& kinematics;
  Vec3<S> pressure{};                    // floor reaction, see pressure()
  std::span<const HandLoad<S>> hands{};  // resting hands
};

// Whether a criterion needs PlacedFrames: its `add` takes no others.
template <class Criterion, class S>
inline constexpr bool looks_at_placement =
    !requires(Criterion & criterion, const MotionFrame<S>& frame) {
  criterion.add(frame);
};

}  // namespace shigusa
