// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>
#include <shigusa/run.hpp>

namespace shigusa {

// A normal deviate of mean 0 and variance 1 by the ratio of two uniform ones (Kinderman and Monahan
// 1977) with Leva's quadratic bounds, which avoid the logarithm in 99 % of the cases (J. L. Leva: A
// fast normal random number generator, ACM TOMS 18, 1992).
[[nodiscard]] inline double normal(Random& random) {
  for (;;) {
    const double u = 1.0 - random.uniform();  // in (0, 1]
    const double v = 1.7156 * (random.uniform() - 0.5);
    const double x = u - 0.449871;
    const double y = abs(v) + 0.386595;
    const double q = x * x + y * (0.19600 * y - 0.25472 * x);
    if (q < 0.27597) return v / u;
    if (q > 0.27846) continue;
    if (v * v <= -4.0 * natural_log(u) * u * u) return v / u;
  }
}

}  // namespace shigusa
