// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>

namespace shigusa {

// Low-pass filter of a clip's angles at `cutoff` (Hz), without a delay: a second-order Butterworth
// filter, forwards and backwards, its cutoff raised so that both together halve the power there.
// Before the first and after the last frame the clip is extended by point reflection, so that the
// ends and their velocities stay. No effect unless the cutoff is below kLowPassShare of the frame
// rate, or with fewer than three frames.
// Source: D. A. Winter, Biomechanics and Motor Control of Human Movement, 4th ed. (2009), 3.4.4.
void low_pass(Clip& clip, double cutoff);

inline constexpr double kLowPassShare = 0.4;

}  // namespace shigusa
