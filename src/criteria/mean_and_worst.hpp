// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

namespace shigusa {

// Half the mean and half the maximum of a value over a motion's frames: criteria based on it weigh
// lasting values and the worst moment equally.
template <class S>
class MeanAndWorst {
 public:
  // Clears the values seen.
  void reset() {
    sum_ = largest_ = S(0);
    count_ = 0;
  }

  // Adds a value, 0 or more.
  void add(const S& value) {
    sum_ = sum_ + value;
    largest_ = max(largest_, value);
    count_ += 1;
  }

  // (½ mean + ½ max) · scale, at most 1; 0 without values.
  [[nodiscard]] S penalty(double scale = 1.0) const {
    if (count_ == 0) return S(0);
    return min(S(1), (sum_ * S(1.0 / count_) + largest_) * S(0.5 * scale));
  }

 private:
  S sum_{};
  S largest_{};
  int count_ = 0;
};

}  // namespace shigusa
