// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/vec3.hpp>

namespace shigusa {

/// 3×3 matrix by columns; as a rotation R_AB, its columns are the axes of frame B seen in A.
template <class S>
struct Mat3 {
  Vec3<S> cx{S(1), S(0), S(0)};  ///< first column
  Vec3<S> cy{S(0), S(1), S(0)};  ///< second column
  Vec3<S> cz{S(0), S(0), S(1)};  ///< third column

  /// The column of that index, 0..2.
  [[nodiscard]] const Vec3<S>& column(int i) const { return i == 0 ? cx : i == 1 ? cy : cz; }

  friend Vec3<S> operator*(const Mat3& m, const Vec3<S>& v) {
    return {m.cx.x * v.x + m.cy.x * v.y + m.cz.x * v.z, m.cx.y * v.x + m.cy.y * v.y + m.cz.y * v.z,
            m.cx.z * v.x + m.cy.z * v.y + m.cz.z * v.z};
  }
  friend Mat3 operator*(const Mat3& a, const Mat3& b) { return {a * b.cx, a * b.cy, a * b.cz}; }
  friend Mat3 operator+(const Mat3& a, const Mat3& b) {
    return {a.cx + b.cx, a.cy + b.cy, a.cz + b.cz};
  }
  friend bool operator==(const Mat3&, const Mat3&) = default;
};

/// A matrix of double.
using Mat3d = Mat3<double>;

/// A constant as the kernel's scalar.
template <class S, class T>
[[nodiscard]] Mat3<S> to_scalar(const Mat3<T>& m) {
  return {to_scalar<S>(m.cx), to_scalar<S>(m.cy), to_scalar<S>(m.cz)};
}

/// mᵀ, of a rotation its inverse.
template <class S>
[[nodiscard]] Mat3<S> transpose(const Mat3<S>& m) {
  return {{m.cx.x, m.cy.x, m.cz.x}, {m.cx.y, m.cy.y, m.cz.y}, {m.cx.z, m.cy.z, m.cz.z}};
}

/// mᵀ v.
template <class S>
[[nodiscard]] Vec3<S> transpose_times(const Mat3<S>& m, const Vec3<S>& v) {
  return {dot(m.cx, v), dot(m.cy, v), dot(m.cz, v)};
}

/// One of a frame's axes.
enum class Axis {
  x,  ///< the first
  y,  ///< the second
  z,  ///< the third
};

/// The columns a and b of a rotation after a turn from a towards b, given its sine and cosine.
template <class S>
[[gnu::always_inline]] inline void turn_columns(Vec3<S>& a, Vec3<S>& b, const SinCos<S>& turn) {
  const Vec3<S> before = a;
  a = a * turn.cos + b * turn.sin;
  b = b * turn.cos - before * turn.sin;
}

/// m · Rot(axis, angle), given the sine and cosine of the angle: turns two columns of m.
template <class S>
[[nodiscard]] Mat3<S> rotated(Mat3<S> m, Axis axis, const SinCos<S>& a) {
  switch (axis) {
    case Axis::x:
      turn_columns(m.cy, m.cz, a);
      break;
    case Axis::y:
      turn_columns(m.cz, m.cx, a);
      break;
    default:
      turn_columns(m.cx, m.cy, a);
  }
  return m;
}

/// The coordinates a and b of a vector, seen after a turn from a towards b.
template <class S>
[[gnu::always_inline]] inline void turn_coordinates(S& a, S& b, const SinCos<S>& turn) {
  const S before = a;
  a = a * turn.cos + b * turn.sin;
  b = b * turn.cos - before * turn.sin;
}

/// v := Rot(axis, -angle) · v, given the sine and cosine of the angle: v seen from a frame that is
/// turned.
template <class S>
[[gnu::always_inline]] inline void turn_back(Vec3<S>& v, Axis axis, const SinCos<S>& a) {
  switch (axis) {
    case Axis::x:
      return turn_coordinates(v.y, v.z, a);
    case Axis::y:
      return turn_coordinates(v.z, v.x, a);
    default:
      return turn_coordinates(v.x, v.y, a);
  }
}
/// v := Rot(axis, angle) · v.
template <class S>
[[gnu::always_inline]] inline void turn_forth(Vec3<S>& v, Axis axis, const SinCos<S>& a) {
  switch (axis) {
    case Axis::x:
      return turn_coordinates(v.z, v.y, a);
    case Axis::y:
      return turn_coordinates(v.x, v.z, a);
    default:
      return turn_coordinates(v.y, v.x, a);
  }
}

/// Rotation about a coordinate axis by an angle in radians.
[[nodiscard]] inline Mat3d rotation(Axis axis, double angle) {
  return rotated(Mat3d{}, axis, sin_cos(angle));
}

/// How `from` must turn to become `to`: axis · sin(angle), world. Near 0 this is the rotation
/// vector, to the third order; beyond 90° it shrinks again.
template <class S>
[[nodiscard]] Vec3<S> rotation_sine(const Mat3<S>& from, const Mat3<S>& to) {
  const Vec3<S> sum = cross(from.cx, to.cx) + cross(from.cy, to.cy) + cross(from.cz, to.cz);
  return sum * S(0.5);
}

/// How far two rotations are apart: 2 sin(angle / 2), which is the angle to the third order, and
/// grows up to 180°.
template <class S>
[[nodiscard]] S rotation_chord(const Mat3<S>& a, const Mat3<S>& b) {
  const Vec3<S> x = a.cx - b.cx;
  const Vec3<S> y = a.cy - b.cy;
  const Vec3<S> z = a.cz - b.cz;
  return sqrt((dot(x, x) + dot(y, y) + dot(z, z)) * S(0.5));
}

/// Rotation vector (axis · angle, radians) of the rotation R, |angle| in [0, π]; error below 1e-14
/// for an R exact to rounding. At π itself either of the two opposite vectors may come out.
///
/// With θ the angle and a the axis, R - Rᵀ holds 2 sin θ a, which gives the axis well up to 90°;
/// R + Rᵀ - 2 cos θ I = 2 (1 - cos θ) a aᵀ gives it well, but for its sign, from 90° on.
template <class S>
[[nodiscard]] Vec3<S> rotation_vector(const Mat3<S>& r) {
  const Vec3<S> skew{r.cy.z - r.cz.y, r.cz.x - r.cx.z, r.cx.y - r.cy.x};
  const S sin2 = norm(skew);
  const S cos2 = r.cx.x + r.cy.y + r.cz.z - S(1);
  const S angle = atan2(sin2, cos2);
  // below that 2 sin θ equals 2 θ to rounding, and is not divided by
  const auto tiny = sin2 < S(1e-9);
  const Vec3<S> acute = skew * select(tiny, S(0.5), angle / select(tiny, S(1), sin2));

  // the longest column of 2 (1 - cos θ) a aᵀ is the one with the largest diagonal entry
  Vec3<S> column{r.cx.x + r.cx.x - cos2, r.cx.y + r.cy.x, r.cx.z + r.cz.x};
  S largest = column.x;
  const Vec3<S> column_y{r.cx.y + r.cy.x, r.cy.y + r.cy.y - cos2, r.cy.z + r.cz.y};
  column = select(column_y.y > largest, column_y, column);
  largest = max(largest, column_y.y);
  const Vec3<S> column_z{r.cx.z + r.cz.x, r.cy.z + r.cz.y, r.cz.z + r.cz.z - cos2};
  column = select(column_z.z > largest, column_z, column);
  const auto wide = cos2 < S(0);
  const S signed_angle = select(dot(column, skew) < S(0), -angle, angle);
  const Vec3<S> obtuse = column * (signed_angle / select(wide, norm(column), S(1)));
  return select(wide, obtuse, acute);
}

}  // namespace shigusa
