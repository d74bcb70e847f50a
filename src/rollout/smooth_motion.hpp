// SPDX-License-Identifier: MIT
#pragma once

#include "rollout/rollout.hpp"

namespace shigusa {

// The motion without kinks: joints that stopped at a limit within a frame, or took over from others
// at once, do so over several frames. The new angles minimise
//
//   Σ (q - q_before)² + λ Σ (Δ³q)²,   Δ³ being third differences, the body at rest before and
//   after,
//
// and each frame is brought back to its paths and contacts. If the smoothed motion violates a
// tolerance, the original is returned. Source: E. Whittaker, Proc. Edinburgh Math. Soc. 41 (1923)
// 63-75.
[[nodiscard]] RolledOut smoothed(const ReachProblem& problem, const Parameters& parameters,
                                 RolledOut rolled);

// Smooths angles (frames × dofs, rad) in the same way; the first and the last frame stay.
void smooth_frames(std::size_t dofs, std::vector<double>& angles);

}  // namespace shigusa
