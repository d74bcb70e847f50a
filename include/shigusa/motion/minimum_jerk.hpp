// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math/vec3.hpp>

namespace shigusa {

// The minimum-jerk profile s(τ) = 10τ³ - 15τ⁴ + 6τ⁵ for τ in [0, 1] (clamped): from 0 to 1 at rest
// at both ends. Source: T. Flash and N. Hogan, J. Neuroscience 5 (1985) 1688-1703.
[[nodiscard]] constexpr double minimum_jerk(double tau) {
  const double t = tau < 0.0 ? 0.0 : tau > 1.0 ? 1.0 : tau;
  return t * t * t * (10.0 - t * (15.0 - 6.0 * t));
}

// Where an effector is to be at each moment: a straight minimum-jerk line from start to goal.
struct EffectorPath {
  Vec3d start{};  // m, world
  Vec3d goal{};   // m, world

  // Position (m, world) at tau = time / duration in [0, 1].
  [[nodiscard]] Vec3d at(double tau) const { return start + (goal - start) * minimum_jerk(tau); }
};

// Rule R9: T = clamp(0.45 s + 0.75 s/m · D, 0.6 s, 2.0 s), and 0.14 s more where the trunk and the
// legs must help (Bertucco, Cesari and Latash 2013).
inline constexpr double kDurationBase = 0.45;      // s
inline constexpr double kDurationPerMetre = 0.75;  // s/m
inline constexpr double kDurationMin = 0.6;        // s
inline constexpr double kDurationMax = 2.0;        // s
inline constexpr double kDurationTrunk = 0.14;     // s

// Duration (s) of a reach over `distance` (m).
[[nodiscard]] inline double reach_duration(double distance, bool needs_trunk) {
  return clamp(kDurationBase + kDurationPerMetre * distance, kDurationMin, kDurationMax) +
         (needs_trunk ? kDurationTrunk : 0.0);
}

}  // namespace shigusa
