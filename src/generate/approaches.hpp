// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/request.hpp>
#include <span>
#include <vector>

#include "planner.hpp"
#include "problem/reachability.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {

// Approaches to the goals, tried in this order until one leads there: a straight hand path; a
// straight hand path with the null space drawn to a posture that is known to arrive; that posture
// alone.
// `straight`: hands go straight even where that takes them through the body.
[[nodiscard]] std::vector<ReachProblem> approaches_to_goal(ReachProblem problem,
                                                           const ClosestReach& reach,
                                                           bool straight = false);

// The parameters' motion on the first approach that brings them to the goal. The same parameters
// always give the same motion, whichever approach they were found on.
[[nodiscard]] std::optional<Arrival> first_arrival(
    std::span<const ReachProblem> approaches, const Parameters& parameters,
    MotionGenerator generator = MotionGenerator::weighted_ik);

// The parameters' motion on the first approach that brings them to the goal, else the motion that
// comes nearest; but a motion that is farther off is better than one whose foot slides.
[[nodiscard]] Arrival nearest_arrival(std::span<const ReachProblem> approaches,
                                      const Parameters& parameters,
                                      MotionGenerator generator = MotionGenerator::weighted_ik);

// The parameters' motion as the generator makes it.
[[nodiscard]] RolledOut play(const ReachProblem& problem, const Parameters& parameters,
                             MotionGenerator generator);

}  // namespace shigusa
