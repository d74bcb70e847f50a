// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

namespace shigusa {

// How much of the orientation of an effector's link a goal is about.
enum class Turning {
  free,   // nothing
  whole,  // all of it
  axis,   // where one of its axes points; it may turn about that
};

// How an effector turns along its path: by the shortest turn, with the minimum-jerk profile.
struct EffectorTurn {
  Turning kind = Turning::free;
  Mat3d start{};             // R_WL in the start posture
  Mat3d goal{};              // R_WL wanted; of Turning::whole
  Vec3d axis{0, 0, 1};       // unit vector in the link's frame; of Turning::axis …
  Vec3d direction{0, 1, 0};  // … and where it is to point, unit vector in the world

  // The orientation wanted at tau = time / duration in [0, 1]: R_WL, and of Turning::axis a turn
  // whose x is the axis' direction.
  [[nodiscard]] Mat3d at(double tau) const;

  // How far the orientation R_WL is from the one wanted at the end: rad, in 0..π.
  template <class S>
  [[nodiscard]] S miss(const Mat3<S>& orientation) const;

  // The same turn to where the orientation R_WL has it.
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

// The shortest turn (rotation vector, rad, in their frame) that takes unit vector a to b; of
// opposite ones it is about any axis square to them.
template <class S>
[[nodiscard]] Vec3<S> turn_between(const Vec3<S>& a, const Vec3<S>& b) {
  const Vec3<S> across = cross(a, b);
  const S sine = norm(across);
  const S cosine = dot(a, b);
  // a sine below this is divided by no more: the angle is its own sine, or the axis is any
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
