// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

namespace shigusa {

// Part of the orientation of an effector's link that a goal prescribes.
enum class Turning {
  free,   // none
  whole,  // all of it
  axis,   // the direction of one axis; the turn about it is free
};

// Turn of an effector along its path: the shortest rotation, with the minimum-jerk profile.
struct EffectorTurn {
  Turning kind = Turning::free;
  Mat3d start{};             // R_WL in the start posture
  Mat3d goal{};              // target R_WL; for Turning::whole
  Vec3d axis{0, 0, 1};       // unit vector in the link's frame; for Turning::axis
  Vec3d direction{0, 1, 0};  // target direction of the axis, unit vector in the world

  // The target orientation at tau = time / duration in [0, 1]: R_WL, or for Turning::axis a
  // rotation whose x column is the axis' direction.
  [[nodiscard]] Mat3d at(double tau) const;

  // Angle between the orientation R_WL and the final target: rad, in 0..π.
  template <class S>
  [[nodiscard]] S miss(const Mat3<S>& orientation) const;

  // The same turn with the orientation R_WL as its end.
  [[nodiscard]] EffectorTurn ending_at(const Mat3d& orientation) const;
};

// Rotation by a rotation vector (axis · angle, rad).
template <class S>
[[nodiscard]] Mat3<S> rotation_by(const Vec3<S>& vector) {
  const S angle = norm(vector);
  const Vec3<S> a = vector * (S(1) / select(angle > S(0), angle, S(1)));
  const SinCos<S> turn = sin_cos(angle);
  // v cos + a × v sin + a (a · v) (1 - cos)
  const auto turned = [&](const Vec3<S>& v) {
    return v * turn.cos + cross(a, v) * turn.sin + a * (dot(a, v) * (S(1) - turn.cos));
  };
  return {turned({S(1), S(0), S(0)}), turned({S(0), S(1), S(0)}), turned({S(0), S(0), S(1)})};
}

// The shortest turn (rotation vector, rad, in their frame) from unit vector a to b; for opposite
// vectors about any perpendicular axis.
template <class S>
[[nodiscard]] Vec3<S> turn_between(const Vec3<S>& a, const Vec3<S>& b) {
  const Vec3<S> across = cross(a, b);
  const S sine = norm(across);
  const S cosine = dot(a, b);
  // for a smaller sine no division: the angle equals its sine, or the axis is arbitrary
  const auto tiny = sine < S(1e-6);
  const Vec3<S> near =
      across * (select(tiny, S(1), atan2(sine, cosine)) / select(tiny, S(1), sine));
  const auto slants = abs(a.x) > S(0.7);
  const Vec3<S> square =
      cross(a, select(slants, Vec3<S>{S(0), S(1), S(0)}, Vec3<S>{S(1), S(0), S(0)}));
  const Vec3<S> opposite = square * (S(kPi) / norm(square));
  return select(tiny & (cosine < S(0)), opposite, near);
}

template <class S>
S EffectorTurn::miss(const Mat3<S>& orientation) const {
  switch (kind) {
    case Turning::whole:
      return norm(rotation_vector(to_scalar<S>(goal) * transpose(orientation)));
    case Turning::axis:
      return norm(turn_between(orientation * to_scalar<S>(axis), to_scalar<S>(direction)));
    case Turning::free:
      break;
  }
  return S(0);
}

}  // namespace shigusa
