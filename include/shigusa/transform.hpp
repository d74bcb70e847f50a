// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/mat3.hpp>

namespace shigusa {

/// Rigid transform X_AB: rotation R_AB and the origin of B in A (metres); X_AB * p_B = p_A.
template <class S>
struct Transform {
  Mat3<S> rotation{};     ///< R_AB
  Vec3<S> translation{};  ///< m, the origin of B in A

  friend Vec3<S> operator*(const Transform& x, const Vec3<S>& p) {
    return x.rotation * p + x.translation;
  }
  friend Transform operator*(const Transform& a, const Transform& b) {
    return {a.rotation * b.rotation, a * b.translation};
  }
};

/// A transform of double.
using Transformd = Transform<double>;

/// X_BA of X_AB.
template <class S>
[[nodiscard]] Transform<S> inverse(const Transform<S>& x) {
  return {transpose(x.rotation), -transpose_times(x.rotation, x.translation)};
}

}  // namespace shigusa
