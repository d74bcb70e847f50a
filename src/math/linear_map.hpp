// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/math.hpp>

namespace shigusa {

// The rotation nearest to a matrix whose columns are nearly orthogonal.
[[nodiscard]] inline Mat3d orthonormal(const Mat3d& m) {
  const Vec3d x = normalized(m.cx, {1, 0, 0});
  const Vec3d z = normalized(cross(x, m.cy), {0, 0, 1});
  return {x, cross(z, x), z};
}

// The inverse of a matrix; none if its columns lie nearly in a plane.
[[nodiscard]] inline std::optional<Mat3d> inverse_of(const Mat3d& m) {
  const Vec3d a = cross(m.cy, m.cz);
  const Vec3d b = cross(m.cz, m.cx);
  const Vec3d c = cross(m.cx, m.cy);
  const double determinant = dot(m.cx, a);
  const double size = norm(m.cx) * norm(m.cy) * norm(m.cz);
  constexpr double kFlat = 1e-9;
  if (!(abs(determinant) > kFlat * size)) return std::nullopt;
  const double over = 1.0 / determinant;
  return transpose(Mat3d{a * over, b * over, c * over});
}

}  // namespace shigusa
