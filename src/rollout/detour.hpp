// SPDX-License-Identifier: MIT
#pragma once

#include "rollout/reach_problem.hpp"

namespace shigusa {

// Clearance (m) at which a hand goes around the body (rule R9).
inline constexpr double kDetourClearance = 0.05;
// Depth (m) of the forearm in the body from which the straight path becomes a detour.
inline constexpr double kDetourDepth = 0.005;
// Share of the time that a via point keeps away from start and end: the smoothest path through a
// nearer one swings out far beyond it (ten times at a twelfth, 200 times at 1/60).
inline constexpr double kDetourMargin = 0.25;

// Bends the paths of the problem around the body: rolls out a motion with uniform weights; where
// the forearm or hand would penetrate trunk or thighs, deeper than at the start, the path gets a
// via point at the deepest moment, pushed outward by the depth and the clearance (paper, rule R9).
// Paths with a detour of their own stay. A detour is rejected if it does not reduce the depth or
// misses the goal.
void add_detours(ReachProblem& problem);

}  // namespace shigusa
