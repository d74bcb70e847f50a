// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/human.hpp>

namespace shigusa {

// Parts of a person brought elsewhere, in their own lengths.

// Thigh and shank of a leg as a triangle with the line from hip to ankle.
struct LegLengths {
  double thigh;
  double shank;

  explicit LegLengths(const Landmarks::Leg& leg)
      : thigh(norm(leg.hip - leg.knee)), shank(norm(leg.knee - leg.ankle)) {}

  // Distance from hip to ankle (m) with the knee bent by an angle (rad).
  [[nodiscard]] double span(double bend) const {
    return sqrt(thigh * thigh + shank * shank + 2.0 * thigh * shank * sin_cos(bend).cos);
  }
};

// Translates the body above the hips, arms included, by a vector (m).
void move_upper_body(Landmarks& person, const Vec3d& by);

// Moves the foot along with an ankle that was at `was`.
void move_foot(Landmarks::Leg& leg, const Vec3d& was);

// Lays the arms along these directions, raised outwards by an angle (rad); each hand keeps its
// orientation to its forearm from `before`.
void lay_arms(Landmarks& person, const Landmarks& before, const Vec3d& upper_arm,
              const Vec3d& forearm, double outwards = 0.0);

}  // namespace shigusa
