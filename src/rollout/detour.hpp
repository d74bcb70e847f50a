// SPDX-License-Identifier: MIT
#pragma once

#include "rollout/reach_problem.hpp"

namespace shigusa {

// Rule R9: a hand goes around the body at this distance (m) …
inline constexpr double kDetourClearance = 0.05;
// … where the straight path would push the forearm deeper than this (m) into it.
inline constexpr double kDetourDepth = 0.005;
// The via point keeps this share of the time away from start and end: the smoothest path through
// one that is nearer to them swings out far beyond it (ten times at a twelfth, 200 times at 1/60).
inline constexpr double kDetourMargin = 0.25;

// Bends the paths of the problem around the body: rolls out a motion with uniform weights; where
// the forearm or hand would pass through trunk or thighs, deeper than at the start, the path gets a
// via point at the deepest moment, pushed outward by the depth and the clearance (paper, rule R9).
// A detour that does not lessen the depth, or does not lead to the goal, is not taken.
void add_detours(ReachProblem& problem);

}  // namespace shigusa
