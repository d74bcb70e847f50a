// SPDX-License-Identifier: MIT
#include "motion/jolt.hpp"

#include <shigusa/scalar.hpp>

namespace shigusa {
namespace {

// At the edge of reach limbs are stretched, and some weights bring them there with a jolt: a change
// of a joint's step by more than this (rad) from one of kMotionSteps frames to the next. Minimum
// jerk over a range of 4 rad has a fifth of it.
constexpr double kJolt = radians(2.0);

}  // namespace

bool jolts(const Clip& clip) {
  for (int f = 2; f < clip.frames; ++f) {
    for (int d = 0; d < clip.dofs; ++d) {
      const auto k = static_cast<std::size_t>(d);
      const double change = clip.frame(f)[k] - 2.0 * clip.frame(f - 1)[k] + clip.frame(f - 2)[k];
      if (abs(change) > kJolt) return true;
    }
  }
  return false;
}

}  // namespace shigusa
