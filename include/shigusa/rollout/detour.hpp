// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/rollout/reach_problem.hpp>

namespace shigusa {

// Rule R9: a hand goes around the body at this distance (m) …
inline constexpr double kDetourClearance = 0.05;
// … where the straight path would push the forearm deeper than this (m) into it.
inline constexpr double kDetourDepth = 0.005;

// Bends the paths of the problem around the body: rolls out a motion with uniform weights; where
// the forearm or hand would pass through trunk or thighs, deeper than at the start, the path gets a
// via point at the deepest moment, pushed outward by the depth and the clearance (paper, rule R9).
// A detour that does not lessen the depth is not taken.
void add_detours(ReachProblem& problem);

}  // namespace shigusa
