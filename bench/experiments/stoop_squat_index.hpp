// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <shigusa/motion/clip.hpp>

namespace shigusa::bench {

// The stoop-squat index of how a motion ends: 100 (1 - drop of the hips / drop of the shoulders),
// heights of joint centres, the middle of both sides where a body has both. A full squat is below
// 30, a full stoop above 90 (P. Schmid and others, 2022). Not a number where shoulders keep their
// height.
[[nodiscard]] double stoop_squat_index(const BodyModel& body, const Clip& clip);

}  // namespace shigusa::bench
