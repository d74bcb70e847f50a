// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "simd/pack.hpp"

namespace shigusa::bench {

// Numbers of floating-point operations of the kernel. Moves and sign changes do not count.
struct Operations {
  std::int64_t additions = 0;  // and subtractions
  std::int64_t multiplications = 0;
  std::int64_t divisions = 0;
  std::int64_t square_roots = 0;
  std::int64_t comparisons = 0;  // min and max too
  std::int64_t sines = 0;        // pairs of sine and cosine; their operations are counted above
};

// Type of comparison results.
struct CountedTruth {
  bool value = false;

  friend CountedTruth operator&(CountedTruth a, CountedTruth b) { return {a.value && b.value}; }
  friend CountedTruth operator|(CountedTruth a, CountedTruth b) { return {a.value || b.value}; }
  friend CountedTruth operator!(CountedTruth a) { return {!a.value}; }
  friend bool any(CountedTruth a) { return a.value; }
  friend bool all(CountedTruth a) { return a.value; }
};

// Scalar of the kernel, like one lane of a pack, that counts its operations.
class Counted {
 public:
  static inline Operations done;

  Counted() = default;
  explicit Counted(float x) : value_(x) {}
  explicit Counted(double x) : value_(static_cast<float>(x)) {}
  explicit Counted(int x) : value_(static_cast<float>(x)) {}

  [[nodiscard]] float value() const { return value_; }

  friend Counted operator+(Counted a, Counted b) {
    ++done.additions;
    return Counted(a.value_ + b.value_);
  }
  friend Counted operator-(Counted a, Counted b) {
    ++done.additions;
    return Counted(a.value_ - b.value_);
  }
  friend Counted operator*(Counted a, Counted b) {
    ++done.multiplications;
    return Counted(a.value_ * b.value_);
  }
  friend Counted operator/(Counted a, Counted b) {
    ++done.divisions;
    return Counted(a.value_ / b.value_);
  }
  friend Counted operator-(Counted a) { return Counted(-a.value_); }
  friend CountedTruth operator<(Counted a, Counted b) {
    ++done.comparisons;
    return {a.value_ < b.value_};
  }
  friend CountedTruth operator>(Counted a, Counted b) { return b < a; }
  friend CountedTruth operator<=(Counted a, Counted b) {
    ++done.comparisons;
    return {a.value_ <= b.value_};
  }
  friend CountedTruth operator>=(Counted a, Counted b) { return b <= a; }

  friend Counted select(CountedTruth condition, Counted yes, Counted no) {
    return condition.value ? yes : no;
  }
  friend Counted min(Counted a, Counted b) { return select(b < a, b, a); }
  friend Counted max(Counted a, Counted b) { return select(a < b, b, a); }
  friend Counted abs(Counted a) { return Counted(__builtin_fabsf(a.value_)); }
  friend Counted sqrt(Counted a) {
    ++done.square_roots;
    return Counted(__builtin_sqrtf(a.value_));
  }

  // operations of the packs' sin_cos, one by one
  friend SinCos<Counted> sin_cos(Counted angle) {
    using C = Counted;
    ++done.sines;
    const C shifted = angle * C(0x1.45f306p-1F) + C(12582912.0F);
    const C n = shifted - C(12582912.0F);
    const C x = ((angle - n * C(0x1.92p+0F)) - n * C(0x1.fb4p-12F)) - n * C(0x1.4442d2p-24F);
    const C z = x * x;
    const auto polynomial = [&](const float(&p)[3]) {
      return C(p[0]) + z * (C(p[1]) + z * C(p[2]));
    };
    const C sine = x + x * (z * polynomial(kSinePolynomial));
    const C cosine = (C(1.0F) - C(0.5F) * z) + z * (z * polynomial(kCosinePolynomial));
    const auto quadrant = std::bit_cast<std::uint32_t>(shifted.value_);
    const C s = quadrant & 1 ? cosine : sine;
    const C c = quadrant & 1 ? sine : cosine;
    return {quadrant & 2 ? -s : s, (quadrant + 1) & 2 ? -c : c};
  }
  friend Counted atan2(Counted y, Counted x) { return single_atan2(y, x); }

 private:
  float value_ = 0.0F;
};

}  // namespace shigusa::bench

namespace shigusa {

template <>
struct ScalarTraits<bench::Counted> {
  using Element = float;
  static constexpr int kLanes = 1;
};

}  // namespace shigusa
