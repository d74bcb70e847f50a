// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// Scalar functions of the kernel for S = double. The kernel calls sin_cos, sqrt, atan2, select, …
// unqualified or through this header, never the C library's transcendental functions: those differ
// between libraries, and a result must have the same bytes everywhere. A further scalar S brings
// its own overloads of the same names. sqrt and + - * / are exact by IEEE 754 on all machines.
namespace shigusa {

/// π.
inline constexpr double kPi = 3.14159265358979323846;
/// A full turn (rad).
inline constexpr double kTwoPi = 2.0 * kPi;

/// The element type and number of lanes of a kernel scalar S.
template <class S>
struct ScalarTraits {
  using Element = S;                ///< type of a lane
  static constexpr int kLanes = 1;  ///< number of lanes
};
/// The element type of a kernel scalar S.
template <class S>
using Element = typename ScalarTraits<S>::Element;

/// Degrees in radians.
[[nodiscard]] constexpr double radians(double angle_deg) { return angle_deg * (kPi / 180.0); }
/// Radians in degrees.
[[nodiscard]] constexpr double degrees(double angle) { return angle * (180.0 / kPi); }

/// condition ? yes : no; for packs the choice is made lane by lane.
[[nodiscard]] inline double select(bool condition, double yes, double no) {
  return condition ? yes : no;
}
/// √x, exactly rounded; NaN below 0.
[[nodiscard]] inline double sqrt(double x) { return __builtin_sqrt(x); }
/// |x|.
[[nodiscard]] inline double abs(double x) { return __builtin_fabs(x); }
/// The smaller of a and b; a if a or b is NaN.
[[nodiscard]] inline double min(double a, double b) { return b < a ? b : a; }
/// The larger of a and b; a if a or b is NaN.
[[nodiscard]] inline double max(double a, double b) { return a < b ? b : a; }
/// x clamped to low..high.
template <class S>
[[nodiscard]] inline S clamp(S x, S low, S high) {
  return min(max(x, low), high);
}
/// Whether the condition holds in any of the lanes.
[[nodiscard]] inline bool any(bool condition) { return condition; }
/// Whether the condition holds in all lanes.
[[nodiscard]] inline bool all(bool condition) { return condition; }
/// x rounded to the nearest integer, |x| below 2^51.
[[nodiscard]] inline double nearest_integer(double x) {
  // adding and subtracting 1.5·2^52 rounds
  constexpr double kRound = 6755399441055744.0;
  return (x + kRound) - kRound;
}
/// False for infinities and NaN.
[[nodiscard]] inline bool is_finite(double x) { return x - x == 0.0; }

/// Sine and cosine of one angle.
template <class S>
struct SinCos {
  S sin;  ///< sine
  S cos;  ///< cosine
};

/// sin and cos of an angle in radians; absolute error below 2.3e-16 for |angle| ≤ 1e6 and below
/// 1e-7 for |angle| ≤ 1e9. Beyond 1.6e9, infinities and NaN included, both are NaN. Cody-Waite
/// reduction to [-π/4, π/4], then the Taylor series to x^17 and x^18, whose remainders there are
/// below 1e-19.
[[nodiscard]] inline SinCos<double> sin_cos(double angle) {
  // π/2 in three parts; the first two have 33 bits each, so n times them is exact up to n = 2^20
  constexpr double kHigh = 0x1.921fb544p+0;
  constexpr double kMiddle = 0x1.0b4611a6p-34;
  constexpr double kLow = 0x1.3198a2e037073p-69;
  const double n = nearest_integer(angle * (2.0 / kPi));
  const bool in_range = n > -1e9 && n < 1e9;
  const double reduced = ((angle - n * kHigh) - n * kMiddle) - n * kLow;
  const double x = in_range ? reduced : __builtin_nan("");
  const double z = x * x;
  // Estrin's scheme: shorter dependency chains than Horner's
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double s0 = (1.0 / 120.0 - 1.0 / 5040.0 * z) * z - 1.0 / 6.0;
  const double s1 = (1.0 / 362880.0 - 1.0 / 39916800.0 * z) +
                    z2 * (1.0 / 6227020800.0 - 1.0 / 1307674368000.0 * z);
  const double s = s0 + (z * z2) * (s1 + z4 * (1.0 / 355687428096000.0));
  const double sine = x + x * (z * s);
  const double c0 = (1.0 / 40320.0 * z - 1.0 / 720.0) * z + 1.0 / 24.0;
  const double c1 = (1.0 / 479001600.0 * z - 1.0 / 3628800.0) +
                    z2 * (1.0 / 20922789888000.0 * z - 1.0 / 87178291200.0);
  const double c = c0 + (z * z2) * (c1 - z4 * (1.0 / 6402373705728000.0));
  const double cosine = (1.0 - 0.5 * z) + z * (z * c);
  // an n out of range must not reach the integer conversion
  const auto quadrant = static_cast<std::uint64_t>(static_cast<std::int64_t>(in_range ? n : 0.0));
  // by bits, as branches on the quadrant mispredict: an odd quadrant exchanges the two; the sign of
  // the sine is bit 1 of the quadrant, of the cosine that of its successor
  auto sine_bits = __builtin_bit_cast(std::uint64_t, sine);
  auto cosine_bits = __builtin_bit_cast(std::uint64_t, cosine);
  const std::uint64_t exchanged = (sine_bits ^ cosine_bits) & (0 - (quadrant & 1));
  sine_bits ^= exchanged ^ ((quadrant & 2) << 62);
  cosine_bits ^= exchanged ^ (((quadrant + 1) & 2) << 62);
  return {__builtin_bit_cast(double, sine_bits), __builtin_bit_cast(double, cosine_bits)};
}

/// Angle of the vector (x, y) in (-π, π], the sign of a zero disregarded; atan2(0, 0) = 0. Absolute
/// error below 7e-16. NaN where x or y is NaN, or both are infinite. Two reductions bring the
/// argument to [-tan 15°, tan 15°], where the Taylor series to u^27 has a remainder below 1e-18.
[[nodiscard]] inline double atan2(double y, double x) {
  const double ax = abs(x);
  const double ay = abs(y);
  const bool steep = ay > ax;
  const double large = steep ? ay : ax;
  const double t = ax + ay == 0.0 ? 0.0 : (steep ? ax : ay) / large;
  constexpr double kTan15 = 0.26794919243112270647;
  constexpr double kSqrt3 = 1.73205080756887729353;
  const bool upper = t > kTan15;
  const double u = upper ? (t * kSqrt3 - 1.0) / (kSqrt3 + t) : t;
  const double z = u * u;
  double series = 0.0;
  for (int n = 27; n >= 1; n -= 2) series = 1.0 / n - z * series;
  const double slope = upper ? u * series + kPi / 6.0 : u * series;
  // the angle is counted from the half axis that lies nearest
  const double axis = steep ? kPi / 2.0 : x < 0.0 ? kPi : 0.0;
  const double angle = steep != (x < 0.0) ? axis - slope : axis + slope;
  return y < 0.0 ? -angle : angle;
}

/// Inverse sine (rad); the argument is clamped to [-1, 1]. Absolute error below 1e-15.
[[nodiscard]] inline double asin(double x) {
  const double c = clamp(x, -1.0, 1.0);
  return atan2(c, sqrt((1.0 - c) * (1.0 + c)));
}
/// Inverse cosine (rad); the argument is clamped to [-1, 1]. Absolute error below 1e-15.
[[nodiscard]] inline double acos(double x) {
  const double c = clamp(x, -1.0, 1.0);
  return atan2(sqrt((1.0 - c) * (1.0 + c)), c);
}

/// Natural logarithm, relative error below 5e-16: x = m 2^e with m in [√½, √2), and the series of
/// 2 artanh((m - 1) / (m + 1)) to the 21st power, whose remainder is below 3e-19. -∞ for 0, NaN
/// below 0 and for NaN.
[[nodiscard]] inline double natural_log(double x) {
  constexpr double kInfinity = __builtin_inf();
  if (!(x > 0.0) || x == kInfinity) return x == 0.0 ? -kInfinity : x > 0.0 ? x : __builtin_nan("");
  // a subnormal number has no exponent of its own
  const bool tiny = x < 0x1p-1022;
  const std::uint64_t bits = __builtin_bit_cast(std::uint64_t, tiny ? x * 0x1p54 : x);
  constexpr std::uint64_t kMantissa = (std::uint64_t{1} << 52) - 1;
  constexpr std::uint64_t kOne = std::uint64_t{1023} << 52;
  double m = __builtin_bit_cast(double, (bits & kMantissa) | kOne);
  std::int64_t e = static_cast<std::int64_t>(bits >> 52) - (tiny ? 1023 + 54 : 1023);
  if (m > 1.41421356237309504880) {
    m *= 0.5;
    ++e;
  }
  const double s = (m - 1.0) / (m + 1.0);
  const double z = s * s;
  double series = 1.0 / 21.0;
  for (int n = 19; n >= 3; n -= 2) series = 1.0 / n + z * series;
  // ln 2 in two parts; the first has 32 bits, so that e times it is exact
  constexpr double kHigh = 0x1.62e42feep-1;
  constexpr double kLow = 0x1.a39ef35793c76p-33;
  const double exponent = static_cast<double>(e);
  return exponent * kHigh + (2.0 * s + (2.0 * s * (z * series) + exponent * kLow));
}

/// e^x, relative error below 5e-16 where the result is a normal number: x = k ln 2 + r with
/// |r| ≤ ln 2 / 2, and the Taylor series to r^14, whose remainder is below 2e-19. 0 below -745.2,
/// +∞ above 709.8, NaN for NaN.
[[nodiscard]] inline double exponential(double x) {
  if (!(x > -746.0)) return x <= -746.0 ? 0.0 : x;
  if (x > 710.0) return __builtin_inf();
  constexpr double kHigh = 0x1.62e42feep-1;  // see natural_log
  constexpr double kLow = 0x1.a39ef35793c76p-33;
  const double k = nearest_integer(x * 1.44269504088896340736);
  const double r = (x - k * kHigh) - k * kLow;
  double series = 1.0;
  for (int n = 14; n >= 2; --n) series = 1.0 + series * (r / n);
  const double power = 1.0 + r * series;
  // 2^k in two factors, since k may be beyond the exponents of normal numbers
  const auto power_of_two = [](std::int64_t n) {
    return __builtin_bit_cast(double, static_cast<std::uint64_t>(n + 1023) << 52);
  };
  const std::int64_t whole = static_cast<std::int64_t>(k);
  const std::int64_t half = whole / 2;
  return power * power_of_two(half) * power_of_two(whole - half);
}

/// A vector or point in three dimensions, in the frame and unit that its owner states.
template <class S>
struct Vec3 {
  S x{};  ///< along the x axis
  S y{};  ///< along the y axis
  S z{};  ///< along the z axis

  /// The coordinate at an index, 0..2.
  [[nodiscard]] const S& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  /// Mutable access to a coordinate.
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

/// condition ? yes : no, lane by lane for packs; `Mask` is the result type of comparing two S.
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

/// Converts a constant to the kernel's scalar type.
template <class S, class T>
[[nodiscard]] Vec3<S> to_scalar(const Vec3<T>& a) {
  return {S(a.x), S(a.y), S(a.z)};
}

/// 3×3 matrix by columns; as a rotation R_AB, its columns are the axes of frame B seen in A.
template <class S>
struct Mat3 {
  Vec3<S> cx{S(1), S(0), S(0)};  ///< first column
  Vec3<S> cy{S(0), S(1), S(0)};  ///< second column
  Vec3<S> cz{S(0), S(0), S(1)};  ///< third column

  /// The column at an index, 0..2.
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

/// Converts a constant to the kernel's scalar type.
template <class S, class T>
[[nodiscard]] Mat3<S> to_scalar(const Mat3<T>& m) {
  return {to_scalar<S>(m.cx), to_scalar<S>(m.cy), to_scalar<S>(m.cz)};
}

/// mᵀ, which is the inverse of a rotation.
template <class S>
[[nodiscard]] Mat3<S> transpose(const Mat3<S>& m) {
  return {{m.cx.x, m.cy.x, m.cz.x}, {m.cx.y, m.cy.y, m.cz.y}, {m.cx.z, m.cy.z, m.cz.z}};
}

/// mᵀ v.
template <class S>
[[nodiscard]] Vec3<S> transpose_times(const Mat3<S>& m, const Vec3<S>& v) {
  return {dot(m.cx, v), dot(m.cy, v), dot(m.cz, v)};
}

/// A coordinate axis of a frame.
enum class Axis {
  x,  ///< the first
  y,  ///< the second
  z,  ///< the third
};

/// Turns the columns a and b of a rotation from a towards b, given the sine and cosine of the
/// angle.
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

/// Transforms the coordinates a and b of a vector into a frame turned from a towards b, given the
/// sine and cosine of the angle.
template <class S>
[[gnu::always_inline]] inline void turn_coordinates(S& a, S& b, const SinCos<S>& turn) {
  const S before = a;
  a = a * turn.cos + b * turn.sin;
  b = b * turn.cos - before * turn.sin;
}

/// v := Rot(axis, -angle) · v, given the sine and cosine of the angle: v in the coordinates of a
/// frame turned by the angle.
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

/// The rotation from `from` to `to` as axis · sin(angle), world. Near 0 it equals the rotation
/// vector to third order; beyond 90° it shrinks again.
template <class S>
[[nodiscard]] Vec3<S> rotation_sine(const Mat3<S>& from, const Mat3<S>& to) {
  const Vec3<S> sum = cross(from.cx, to.cx) + cross(from.cy, to.cy) + cross(from.cz, to.cz);
  return sum * S(0.5);
}

/// The distance of two rotations: 2 sin(angle / 2), which equals the angle to third order and grows
/// up to 180°.
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
  // below this, 2 sin θ equals 2 θ to rounding; avoids a division by 0
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

/// Unit quaternion, order x, y, z, w; q and -q are the same rotation.
template <class S>
struct Quat {
  S x{};      ///< x of axis · sin(angle / 2)
  S y{};      ///< y of the same
  S z{};      ///< z of the same
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

inline constexpr double kUnitSlack = 1e-3;  ///< tolerance of a unit quaternion's squared length

/// The squared length, 1 for a rotation.
[[nodiscard]] inline double squared_length(const Quatd& q) {
  return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}
/// Whether the squared length is 1 to within kUnitSlack.
[[nodiscard]] inline bool is_unit(const Quatd& q) {
  return abs(squared_length(q) - 1.0) < kUnitSlack;
}

/// The one of q and -q, which are the same rotation, that is nearer to `near`.
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

/// The quaternion of a rotation matrix, with w ≥ 0, from the largest of its four squared
/// components, which avoids division by small numbers.
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

/// The inverse X_BA of X_AB.
template <class S>
[[nodiscard]] Transform<S> inverse(const Transform<S>& x) {
  return {transpose(x.rotation), -transpose_times(x.rotation, x.translation)};
}

}  // namespace shigusa
