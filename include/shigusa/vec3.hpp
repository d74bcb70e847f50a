// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/scalar.hpp>

namespace shigusa {

/// A vector of three coordinates, or a point, in the frame and unit that its owner tells.
template <class S>
struct Vec3 {
  S x{};  ///< along the x axis
  S y{};  ///< along the y axis
  S z{};  ///< along the z axis

  /// The coordinate of that index, 0..2.
  [[nodiscard]] const S& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  /// The same, to be changed.
  [[nodiscard]] S& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }

  /// Adds b.
  Vec3& operator+=(const Vec3& b) {
    x = x + b.x;
    y = y + b.y;
    z = z + b.z;
    return *this;
  }
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(const Vec3& a, S s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Vec3 operator*(S s, const Vec3& a) { return {a.x * s, a.y * s, a.z * s}; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// A vector of double.
using Vec3d = Vec3<double>;

/// a · b.
template <class S>
[[nodiscard]] S dot(const Vec3<S>& a, const Vec3<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a × b.
template <class S>
[[nodiscard]] Vec3<S> cross(const Vec3<S>& a, const Vec3<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// |a|.
template <class S>
[[nodiscard]] S norm(const Vec3<S>& a) {
  return sqrt(dot(a, a));
}

/// condition ? yes : no, lane by lane for packs; `Mask` is what comparing two S gives.
template <class Mask, class S>
[[nodiscard]] Vec3<S> select(const Mask& condition, const Vec3<S>& yes, const Vec3<S>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y),
          select(condition, yes.z, no.z)};
}

/// a / |a|, or `fallback` where |a| is below 1e-12; NaN stays NaN.
[[nodiscard]] inline Vec3d normalized(const Vec3d& a, const Vec3d& fallback = {0, 1, 0}) {
  const double length = norm(a);
  return length < 1e-12 ? fallback : a * (1.0 / length);
}

/// A constant as the kernel's scalar.
template <class S, class T>
[[nodiscard]] Vec3<S> to_scalar(const Vec3<T>& a) {
  return {S(a.x), S(a.y), S(a.z)};
}

}  // namespace shigusa
