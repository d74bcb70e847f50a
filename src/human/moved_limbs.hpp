// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/human.hpp>

namespace shigusa {

// Parts of a person brought elsewhere, in their own lengths.

// A triangle of thigh and shank seen from the ankle.
struct LegLengths {
  double thigh;
  double shank;

  explicit LegLengths(const Landmarks::Leg& leg)
      : thigh(norm(leg.hip - leg.knee)), shank(norm(leg.knee - leg.ankle)) {}

  // From hip to ankle (m) when the knee is bent by an angle (rad).
  [[nodiscard]] double span(double bend) const {
    return sqrt(thigh * thigh + shank * shank + 2.0 * thigh * shank * sin_cos(bend).cos);
  }
};

// The body above the hips, arms included, moved by a vector (m).
void move_upper_body(Landmarks& person, const Vec3d& by);

// The foot moved along with an ankle that was elsewhere.
void move_foot(Landmarks::Leg& leg, const Vec3d& was);

// The arms laid along these directions, raised outwards by an angle (rad), each hand on its forearm
// as it was in `before`.
void lay_arms(Landmarks& person, const Landmarks& before, const Vec3d& upper_arm,
              const Vec3d& forearm, double outwards = 0.0);

}  // namespace shigusa
