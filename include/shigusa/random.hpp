// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shigusa {

/// Counter-based random numbers: the k-th number is a pure function of (seed, stream, k), so work
/// split over threads or machines draws the same numbers. The mixing function is the finaliser of
/// SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, OOPSLA 2014).
class Random {
 public:
  /// `stream` separates independent users of one seed (searches, restarts, tests).
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : key_(mix(seed + kGolden) ^ mix(stream * kGolden + 0x6A09E667F3BCC909ULL)) {}

  /// Next 64 uniform bits.
  std::uint64_t next() { return mix(key_ + kGolden * ++counter_); }

  /// Uniform in [0, 1): 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

  /// Uniform in [low, high], high itself only by rounding.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform integer in [0, count), count ≥ 1; each has a probability within 2^-32 of 1 / count.
  std::uint32_t below(std::uint32_t count) {
    const std::uint64_t high = next() >> 32;
    return static_cast<std::uint32_t>((high * count) >> 32);
  }

  /// True with the given probability in [0, 1].
  bool chance(double probability) { return uniform() < probability; }

  /// How many numbers have been drawn.
  [[nodiscard]] std::uint64_t counter() const { return counter_; }

 private:
  static constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ULL;

  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace shigusa
