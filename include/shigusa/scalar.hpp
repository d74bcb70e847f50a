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

/// Tells of a scalar S of the kernel which numbers it is made of.
template <class S>
struct ScalarTraits {
  using Element = S;                ///< what each lane is
  static constexpr int kLanes = 1;  ///< numbers that S holds
};
/// The type of the constants that a scalar S is computed with.
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
/// The smaller of both; a where a or b is NaN.
[[nodiscard]] inline double min(double a, double b) { return b < a ? b : a; }
/// The larger of both; a where a or b is NaN.
[[nodiscard]] inline double max(double a, double b) { return a < b ? b : a; }
/// x held to low..high.
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
  S sin;  ///< of the angle
  S cos;  ///< of the same
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
  // by pairs (Estrin's scheme), which wait less for each other than Horner's
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
  // by bits, as nobody can foretell the quadrant: an odd one has the two exchanged, and the sign of
  // the sine is bit 1 of it, of the cosine that of its successor
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

}  // namespace shigusa
