// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/scalar.hpp>

namespace shigusa {

// How far beyond the last trial a line search goes on, at most.
inline constexpr double kStretch = 8.0;
// How far from both ends of an interval a trial stays that is not free, as a share of it.
inline constexpr double kSecantMargin = 0.1;

// Where along a line the slope's root lies.
struct Bracket {
  double low = 0.0;  // the function falls there …
  double low_slope = 0.0;
  double high = -1.0;  // … but not there; -1: not known yet
  double high_slope = 0.0;
  double before = 0.0;  // of two trials that fell, the former
  double before_slope = 0.0;

  void take(double t, double slope, bool falls) {
    if (falls) {
      before = low;
      before_slope = low_slope;
      low = t;
      low_slope = slope;
    } else {
      high = t;
      high_slope = slope;
    }
  }

  // Where to try next, by secants; `freely`: however near to an end of the bracket.
  [[nodiscard]] double next(bool freely) const {
    if (high < 0.0) {
      const double bend = low_slope - before_slope;
      const double root = bend > 0.0 ? low - low_slope * (low - before) / bend : kStretch * low;
      return clamp(root, 1.1 * low, kStretch * low);
    }
    const double bend = high_slope - low_slope;
    double share = high_slope > 0.0 && bend > 0.0 ? -low_slope / bend : 0.5;
    if (!freely || !(share > 0.0)) share = clamp(share, kSecantMargin, 1.0 - kSecantMargin);
    return low + share * (high - low);
  }
};

}  // namespace shigusa
