// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

namespace shigusa {

// Index of the coordinate with the largest absolute value, the first among equals.
[[nodiscard]] inline int main_axis(const Vec3d& v) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) axis = abs(v[i]) > abs(v[axis]) ? i : axis;
  return axis;
}

// The coordinate axis nearest to a direction, as a unit vector.
[[nodiscard]] inline Vec3d nearest_axis(const Vec3d& v) {
  const int axis = main_axis(v);
  Vec3d unit{};
  unit[axis] = v[axis] < 0.0 ? -1.0 : 1.0;
  return unit;
}

// Whether every coordinate is a number with an absolute value of at most `most`.
[[nodiscard]] inline bool is_within(const Vec3d& v, double most) {
  return abs(v.x) <= most && abs(v.y) <= most && abs(v.z) <= most;
}
[[nodiscard]] inline bool is_within(const Mat3d& m, double most) {
  return is_within(m.cx, most) && is_within(m.cy, most) && is_within(m.cz, most);
}

// A rotation with scales along its own axes.
[[nodiscard]] inline Mat3d scaled_columns(const Mat3d& r, const Vec3d& scale) {
  return {r.cx * scale.x, r.cy * scale.y, r.cz * scale.z};
}

}  // namespace shigusa
