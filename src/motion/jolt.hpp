// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>

namespace shigusa {

// At the edge of reach limbs are stretched, and some weights bring them there with a jolt: a change
// of a joint's step by more than this (rad) from one of kMotionSteps frames to the next. Minimum
// jerk over a range of 4 rad has a fifth of it.
inline constexpr double kJolt = radians(2.0);

// Whether some joint's step changes from one frame to the next by more than a smooth motion's does.
[[nodiscard]] bool jolts(const Clip& clip);

}  // namespace shigusa
