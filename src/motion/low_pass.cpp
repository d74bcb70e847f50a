// SPDX-License-Identifier: MIT
#include "motion/low_pass.hpp"

#include <algorithm>
#include <shigusa/math.hpp>

namespace shigusa {
namespace {

constexpr double kTwice = 0.80224326;  // (√2 - 1)^¼: cutoff of two passes over that of one
constexpr double kRoot2 = 1.41421356237309504880;
constexpr double kSettles =
    2.0;  // periods of the cutoff, after which the effect of the initial value vanishes

// y = b0 (x + 2 x₋₁ + x₋₂) - a1 y₋₁ - a2 y₋₂
class Butterworth {
 public:
  explicit Butterworth(double cutoff_share) {
    const SinCos<double> turn = sin_cos(kPi * cutoff_share);
    const double k = turn.sin / (turn.cos * kTwice);
    const double scale = 1.0 / (1.0 + kRoot2 * k + k * k);
    b0_ = k * k * scale;
    a1_ = 2.0 * (k * k - 1.0) * scale;
    a2_ = (1.0 - kRoot2 * k + k * k) * scale;
  }

  // Filters in place, as if the first value had always been there.
  template <class Iterator>
  void run(Iterator begin, Iterator end) const {
    double first = *begin * (1.0 - b0_);
    double second = *begin * (b0_ - a2_);
    for (Iterator x = begin; x != end; ++x) {
      const double y = b0_ * *x + first;
      first = 2.0 * b0_ * *x - a1_ * y + second;
      second = b0_ * *x - a2_ * y;
      *x = y;
    }
  }

 private:
  double b0_ = 1.0;
  double a1_ = 0.0;
  double a2_ = 0.0;
};

}  // namespace

void low_pass(Clip& clip, double cutoff) {
  const double share = cutoff * clip.frame_time;
  if (clip.frames < 3 || !(share > 0.0) || !(share < kLowPassShare)) return;
  const Butterworth filter(share);
  const auto frames = static_cast<std::size_t>(clip.frames);
  const auto dofs = static_cast<std::size_t>(clip.dofs);
  const auto settles = static_cast<std::size_t>(min(kSettles / share, 1e6)) + 1;
  const std::size_t before = std::min(frames - 1, settles);
  std::vector<double> values(frames + 2 * before);
  for (std::size_t d = 0; d < dofs; ++d) {
    const auto at = [&](std::size_t f) -> double& { return clip.angles[f * dofs + d]; };
    for (std::size_t f = 0; f < frames; ++f) values[before + f] = at(f);
    for (std::size_t k = 1; k <= before; ++k) {
      values[before - k] = 2.0 * at(0) - at(k);
      values[before + frames - 1 + k] = 2.0 * at(frames - 1) - at(frames - 1 - k);
    }
    filter.run(values.begin(), values.end());
    filter.run(values.rbegin(), values.rend());
    for (std::size_t f = 0; f < frames; ++f) at(f) = values[before + f];
  }
}

}  // namespace shigusa
