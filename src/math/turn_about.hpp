// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

namespace shigusa {

// The rotation about a unit axis by an angle (rad).
[[nodiscard]] inline Mat3d turn_about(const Vec3d& axis, double angle) {
  const SinCos<double> half = sin_cos(0.5 * angle);
  return to_matrix(Quatd{axis.x * half.sin, axis.y * half.sin, axis.z * half.sin, half.cos});
}

}  // namespace shigusa
