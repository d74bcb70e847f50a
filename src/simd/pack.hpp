// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <shigusa/math.hpp>
#include <utility>
#ifdef __SSE__
#include <immintrin.h>
#endif

// N numbers in the lanes of one vector register, by the vector extensions of GCC and Clang. Lanes
// are independent, and each operation is one rounding of IEEE 754, so a lane's results do not
// depend on N or on the instruction set.
namespace shigusa {

// Result of comparing packs, true or false for each lane. `Bits` is an integer of the lanes' size.
template <class Bits, int N>
struct LaneMask {
  typedef Bits Vector __attribute__((vector_size(sizeof(Bits) * N)));
  Vector lanes;  // -1 or 0

  [[nodiscard]] bool operator[](int lane) const { return lanes[lane] != 0; }
  friend LaneMask operator&(const LaneMask& a, const LaneMask& b) { return {a.lanes & b.lanes}; }
  friend LaneMask operator|(const LaneMask& a, const LaneMask& b) { return {a.lanes | b.lanes}; }
  friend LaneMask operator!(const LaneMask& a) { return {~a.lanes}; }
};

template <int N>
using Mask = LaneMask<std::int32_t, N>;

// The kernel's scalar for N individuals at once. T is float.
template <class T, int N>
struct Pack {
  typedef T Vector __attribute__((vector_size(sizeof(T) * N)));
  using Bits = typename Mask<N>::Vector;
  Vector lanes{};

  Pack() = default;
  explicit Pack(Vector v) : lanes(v) {}
  // Fills all lanes with the same number; a double is rounded to float.
  explicit Pack(float x) : Pack(x, std::make_integer_sequence<int, N>{}) {}
  explicit Pack(double x) : Pack(static_cast<float>(x)) {}
  explicit Pack(int x) : Pack(static_cast<float>(x)) {}

  [[nodiscard]] float operator[](int lane) const { return lanes[lane]; }
  void set(int lane, float x) { lanes[lane] = x; }

  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.lanes + b.lanes); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.lanes - b.lanes); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.lanes * b.lanes); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.lanes / b.lanes); }
  friend Pack operator-(const Pack& a) { return Pack(-a.lanes); }
  friend Mask<N> operator<(const Pack& a, const Pack& b) { return {a.lanes < b.lanes}; }
  friend Mask<N> operator>(const Pack& a, const Pack& b) { return {a.lanes > b.lanes}; }
  friend Mask<N> operator<=(const Pack& a, const Pack& b) { return {a.lanes <= b.lanes}; }
  friend Mask<N> operator>=(const Pack& a, const Pack& b) { return {a.lanes >= b.lanes}; }

 private:
  template <int... Lanes>
  Pack(float x, std::integer_sequence<int, Lanes...>) : lanes{((void)Lanes, x)...} {}
};

template <class T, int N>
struct ScalarTraits<Pack<T, N>> {
  using Element = T;
  static constexpr int kLanes = N;
};

template <int N>
[[nodiscard]] inline Pack<float, N> select(const Mask<N>& condition, const Pack<float, N>& yes,
                                           const Pack<float, N>& no) {
  return Pack<float, N>(condition.lanes ? yes.lanes : no.lanes);
}
template <int N>
[[nodiscard]] inline Pack<float, N> min(const Pack<float, N>& a, const Pack<float, N>& b) {
  return Pack<float, N>(b.lanes < a.lanes ? b.lanes : a.lanes);
}
template <int N>
[[nodiscard]] inline Pack<float, N> max(const Pack<float, N>& a, const Pack<float, N>& b) {
  return Pack<float, N>(a.lanes < b.lanes ? b.lanes : a.lanes);
}
template <int N>
[[nodiscard]] inline Pack<float, N> abs(const Pack<float, N>& a) {
  using Bits = typename Pack<float, N>::Bits;
  using Vector = typename Pack<float, N>::Vector;
  return Pack<float, N>((Vector)((Bits)a.lanes & 0x7fffffff));
}
template <int N>
[[nodiscard]] inline Pack<float, N> sqrt(const Pack<float, N>& a) {
#ifdef __wasm_simd128__
  // compilers do not vectorise the loop over lanes here
  if constexpr (N == 4) return Pack<float, N>(__builtin_wasm_sqrt_f32x4(a.lanes));
#endif
  Pack<float, N> root;
  // one instruction if the set has it
  for (int lane = 0; lane < N; ++lane) root.lanes[lane] = __builtin_sqrtf(a.lanes[lane]);
  return root;
}
template <int N>
[[nodiscard]] inline bool any(const Mask<N>& condition) {
#ifdef __wasm_simd128__
  typedef signed char Bytes __attribute__((vector_size(16)));
  if constexpr (N == 4) return __builtin_wasm_any_true_v128((Bytes)condition.lanes) != 0;
#endif
// compilers would extract the lanes one by one
#ifdef __AVX512DQ__
  if constexpr (N == 16) return _mm512_movepi32_mask((__m512i)condition.lanes) != 0;
#endif
#ifdef __AVX__
  if constexpr (N == 8) return _mm256_movemask_ps((__m256)condition.lanes) != 0;
#endif
#ifdef __SSE__
  if constexpr (N == 4) return _mm_movemask_ps((__m128)condition.lanes) != 0;
#endif
  std::int32_t bits = 0;
  for (int lane = 0; lane < N; ++lane) bits |= condition.lanes[lane];
  return bits != 0;
}
template <int N>
[[nodiscard]] inline bool all(const Mask<N>& condition) {
  return !any(!condition);
}

// The nearest integer to x, for |x| below 2^22.
template <int N>
[[nodiscard]] inline Pack<float, N> nearest_integer(const Pack<float, N>& x) {
  // adding and subtracting 1.5·2^23 rounds
  return (x + Pack<float, N>(12582912.0F)) - Pack<float, N>(12582912.0F);
}

// sin x = x + x³ p(x²) and cos x = 1 - x²/2 + x⁴ q(x²) on [-π/4, π/4]: minimax coefficients
// (Remez), rounded to float; absolute error 2.3e-9 and 5.1e-10.
inline constexpr float kSinePolynomial[] = {-0.1666665066920138F, 0.0083319786578888195F,
                                            -0.0001949563556596963F};
inline constexpr float kCosinePolynomial[] = {0.041666646866331792F, -0.0013887367510006495F,
                                              2.4438450907381384e-5F};

// Sine and cosine of angles in radians; absolute error below 1.2e-7 for |angle| ≤ 1e4; meaningless
// beyond; NaN for NaN. Cody-Waite reduction to [-π/4, π/4], then minimax polynomials.
template <int N>
[[nodiscard]] inline SinCos<Pack<float, N>> sin_cos(const Pack<float, N>& angle) {
  using P = Pack<float, N>;
  using Bits = typename P::Bits;
  using Vector = typename P::Vector;
  // adding 1.5·2^23 rounds to the nearest integer, whose last bits are those of the sum
  const P shifted = angle * P(0x1.45f306p-1F) + P(12582912.0F);
  const P n = shifted - P(12582912.0F);
  // π/2 in three parts; the first two have few bits, so that their products with n are exact
  const P x = ((angle - n * P(0x1.92p+0F)) - n * P(0x1.fb4p-12F)) - n * P(0x1.4442d2p-24F);
  const P z = x * x;
  const auto polynomial = [&](const float(&p)[3]) { return P(p[0]) + z * (P(p[1]) + z * P(p[2])); };
  const P sine = x + x * (z * polynomial(kSinePolynomial));
  const P cosine = (P(1.0F) - P(0.5F) * z) + z * (z * polynomial(kCosinePolynomial));
  const Bits quadrant = (Bits)shifted.lanes;
  const Mask<N> even{(quadrant & 1) == 0};
  // bit 1 of the quadrant is the sign of the sine, that of its successor the sign of the cosine
  const Bits sine_sign = (quadrant & 2) << 30;
  const Bits cosine_sign = ((quadrant + 1) & 2) << 30;
  const P s = select(even, sine, cosine);
  const P c = select(even, cosine, sine);
  return {P((Vector)((Bits)s.lanes ^ sine_sign)), P((Vector)((Bits)c.lanes ^ cosine_sign))};
}

// Angle of the vector (x, y) in [-π, π] for a scalar S in single precision; 0 for (0, 0), the sign
// of a zero is ignored, NaN for NaN. Absolute error below 4e-7. The two reductions of the scalar
// atan2, then the Taylor series to u^11, with a remainder below 3e-9.
template <class S>
[[nodiscard]] inline S single_atan2(const S& y, const S& x) {
  const S ax = abs(x);
  const S ay = abs(y);
  const auto steep = ay > ax;
  const S t = select(steep, ax, ay) / max(select(steep, ay, ax), S(1e-37F));
  const auto upper = t > S(0.26794919F);
  const S u = select(upper, (t * S(1.7320508F) - S(1.0F)) / (S(1.7320508F) + t), t);
  const S z = u * u;
  S series(1.0F / 11.0F);
  for (int n = 9; n >= 1; n -= 2) series = S(1.0F / static_cast<float>(n)) - z * series;
  const S slope = u * series + select(upper, S(0.52359878F), S(0.0F));
  const auto behind = x < S(0.0F);
  const S flat = select(behind, S(3.14159265F) - slope, slope);
  const S upright = select(behind, S(1.57079633F) + slope, S(1.57079633F) - slope);
  const S angle = select(steep, upright, flat);
  return select(y < S(0.0F), -angle, angle);
}
template <int N>
[[nodiscard]] inline Pack<float, N> atan2(const Pack<float, N>& y, const Pack<float, N>& x) {
  return single_atan2(y, x);
}

// Inverse cosine (rad); the argument is clamped to [-1, 1]. Absolute error below 5e-7.
template <int N>
[[nodiscard]] inline Pack<float, N> acos(const Pack<float, N>& x) {
  using P = Pack<float, N>;
  const P c = clamp(x, P(-1.0F), P(1.0F));
  return single_atan2(sqrt((P(1.0F) - c) * (P(1.0F) + c)), c);
}

}  // namespace shigusa
