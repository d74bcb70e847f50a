// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <shigusa/math.hpp>
#include <shigusa/run.hpp>

namespace shigusa::testing_support {

// A direction drawn uniformly, of length 1 to rounding.
inline Vec3d random_direction(Random& random) {
  for (;;) {
    const Vec3d v{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    if (norm(v) <= 1.0 && norm(v) > 0.1) return normalized(v);
  }
}

// Rodrigues' formula in long double with the C library: each entry exact to its last rounding.
inline Mat3d rotation_about(const Vec3d& axis, double angle) {
  using Real = long double;
  const Real n = std::sqrt(Real(axis.x) * axis.x + Real(axis.y) * axis.y + Real(axis.z) * axis.z);
  const Real a[3] = {axis.x / n, axis.y / n, axis.z / n};
  const Real s = std::sin(Real(angle));
  // 1 - cos θ without cancellation
  const Real half = std::sin(Real(angle) / 2);
  const Real v = 2 * half * half;
  const auto entry = [&](int row, int column) {
    if (row == column) return static_cast<double>(1 - v * (1 - a[row] * a[row]));
    const int third = 3 - row - column;
    const Real sign = (column + 1) % 3 == row ? 1 : -1;
    return static_cast<double>(v * a[row] * a[column] + sign * s * a[third]);
  };
  const auto column = [&](int c) { return Vec3d{entry(0, c), entry(1, c), entry(2, c)}; };
  return {column(0), column(1), column(2)};
}

// The largest difference of two entries.
inline double distance(const Mat3d& a, const Mat3d& b) {
  double largest = 0.0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      largest = std::fmax(largest, std::fabs(a.column(column)[row] - b.column(column)[row]));
    }
  }
  return largest;
}

}  // namespace shigusa::testing_support
