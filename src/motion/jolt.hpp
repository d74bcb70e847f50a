// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>

namespace shigusa {

// Largest change of a joint's step (rad) from one of kMotionSteps frames to the next that is no
// jolt: at the edge of reach limbs are stretched, and some weights bring them there with a jolt.
// Minimum jerk over a range of 4 rad has a fifth of it.
inline constexpr double kJolt = radians(2.0);

// Whether some joint's step changes from one frame to the next by more than in a smooth motion.
[[nodiscard]] bool jolts(const Clip& clip);

}  // namespace shigusa
