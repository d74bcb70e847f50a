// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/hierarchy/generator.hpp>

namespace shigusa {

// A motion with all that is told of it.
[[nodiscard]] Candidate make_candidate(const Task& task, const ReachProblem& problem,
                                       const Parameters& parameters, RolledOut rolled);

// The joints that pass their limits by more than anyone sees, the worst first.
[[nodiscard]] std::vector<LimitExcess> limit_excess(const BodyModel& body, const Clip& clip);

// Distance that is left to the goals (m), the root of the summed squares.
[[nodiscard]] double miss_of(const Candidate& candidate);

// Orders scores, a NaN last.
[[nodiscard]] double ranking(const Score& score);

// Largest root-mean-square difference of two motions' joint angles over their frames (rad).
[[nodiscard]] double largest_distance(const Clip& a, const Clip& b);
// The same of the postures they end in.
[[nodiscard]] double final_distance(const Clip& a, const Clip& b);

}  // namespace shigusa
