// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/mat3.hpp>

namespace shigusa {

/// Unit quaternion, order x, y, z, w; q and -q are the same rotation.
template <class S>
struct Quat {
  S x{};      ///< axis · sin(angle / 2), its x
  S y{};      ///< its y
  S z{};      ///< its z
  S w{S(1)};  ///< cos(angle / 2)

  friend Quat operator*(const Quat& a, const Quat& b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
            a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
  }
  friend bool operator==(const Quat&, const Quat&) = default;
};

/// A quaternion of double.
using Quatd = Quat<double>;

inline constexpr double kUnitSlack = 1e-3;  ///< of a unit quaternion's squared length

/// The square of the length: 1 of a rotation.
[[nodiscard]] inline double squared_length(const Quatd& q) {
  return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}
/// Whether it is of length 1, to within kUnitSlack.
[[nodiscard]] inline bool is_unit(const Quatd& q) {
  return abs(squared_length(q) - 1.0) < kUnitSlack;
}

/// Of q and -q, which are the same rotation, the one nearer to `near`.
[[nodiscard]] inline Quatd nearer(const Quatd& q, const Quatd& near) {
  const bool other = q.x * near.x + q.y * near.y + q.z * near.z + q.w * near.w < 0.0;
  return other ? Quatd{-q.x, -q.y, -q.z, -q.w} : q;
}

/// Rotation about a coordinate axis by an angle in radians.
[[nodiscard]] inline Quatd axis_rotation(Axis axis, double angle) {
  const SinCos<double> half = sin_cos(0.5 * angle);
  return {axis == Axis::x ? half.sin : 0.0, axis == Axis::y ? half.sin : 0.0,
          axis == Axis::z ? half.sin : 0.0, half.cos};
}

/// The rotation matrix of a unit quaternion.
template <class S>
[[nodiscard]] Mat3<S> to_matrix(const Quat<S>& q) {
  const S two(2);
  const S one(1);
  return {{one - two * (q.y * q.y + q.z * q.z), two * (q.x * q.y + q.z * q.w),
           two * (q.x * q.z - q.y * q.w)},
          {two * (q.x * q.y - q.z * q.w), one - two * (q.x * q.x + q.z * q.z),
           two * (q.y * q.z + q.x * q.w)},
          {two * (q.x * q.z + q.y * q.w), two * (q.y * q.z - q.x * q.w),
           one - two * (q.x * q.x + q.y * q.y)}};
}

/// The quaternion of a rotation matrix, with w ≥ 0; from the largest of the four squared parts, so
/// no small number is divided by.
[[nodiscard]] inline Quatd to_quat(const Mat3d& r) {
  const double xx = r.cx.x;
  const double yy = r.cy.y;
  const double zz = r.cz.z;
  Quatd q;
  if (xx + yy + zz >= max(xx, max(yy, zz))) {
    q = {r.cy.z - r.cz.y, r.cz.x - r.cx.z, r.cx.y - r.cy.x, 1.0 + xx + yy + zz};
  } else if (xx >= yy && xx >= zz) {
    q = {1.0 + xx - yy - zz, r.cx.y + r.cy.x, r.cz.x + r.cx.z, r.cy.z - r.cz.y};
  } else if (yy >= zz) {
    q = {r.cx.y + r.cy.x, 1.0 - xx + yy - zz, r.cy.z + r.cz.y, r.cz.x - r.cx.z};
  } else {
    q = {r.cz.x + r.cx.z, r.cy.z + r.cz.y, 1.0 - xx - yy + zz, r.cx.y - r.cy.x};
  }
  const double scale = 1.0 / sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  const double sign = q.w < 0.0 ? -scale : scale;
  return {q.x * sign, q.y * sign, q.z * sign, q.w * sign};
}

}  // namespace shigusa
