// SPDX-License-Identifier: MIT
#pragma once

#include "rollout/rollout.hpp"

namespace shigusa {

// The motion without its kinks: joints that stopped at a limit within a frame, or took over from
// others at once, do so within some frames. Angles become those of least
//
//   Σ (q - q_before)² + λ Σ (Δ³q)²,   Δ³ being third differences, the body at rest before and
//   after,
//
// and each frame is brought back to its paths and contacts. Where the smoother motion would miss
// what this one meets, this one is returned. Source: E. Whittaker, Proc. Edinburgh Math. Soc. 41
// (1923) 63-75.
[[nodiscard]] RolledOut smoothed(const ReachProblem& problem, const Parameters& parameters,
                                 RolledOut rolled);

// Smooths angles (frames × dofs, rad) so, but for the first and the last frame.
void smooth_frames(std::size_t dofs, std::vector<double>& angles);

}  // namespace shigusa
