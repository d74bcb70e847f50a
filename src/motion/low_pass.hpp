// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>

namespace shigusa {

// Takes what is faster than `cutoff` (Hz) out of a clip's angles, without a delay: Butterworth's
// filter of second order forwards and backwards, its cutoff raised so that both together halve the
// power there. Before its first and after its last frame the clip is taken as going on turned about
// them, so that ends and speeds there stay. Nothing is changed where the cutoff is not below
// kLowPassShare of the frame rate, or there are fewer than three frames.
// Source: D. A. Winter, Biomechanics and Motor Control of Human Movement, 4th ed. (2009), 3.4.4.
void low_pass(Clip& clip, double cutoff);

inline constexpr double kLowPassShare = 0.4;

}  // namespace shigusa
