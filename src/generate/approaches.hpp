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

// The approaches to the goals, in the order in which they are tried until one arrives: a hand path
// that is straight or goes around the body (not with lifted heels or at the edge of reach); the
// same path with the null space drawn to a posture known to arrive; that posture alone.
// `straight`: hand paths stay straight even where they pass through the body.
[[nodiscard]] std::vector<ReachProblem> approaches_to_goal(ReachProblem problem,
                                                           const ClosestReach& reach,
                                                           bool straight = false);

// The motion of the parameters on the first approach that arrives at the goals. The same parameters
// always give the same motion, whichever approach they were found on.
[[nodiscard]] std::optional<Arrival> first_arrival(
    std::span<const ReachProblem> approaches, const Parameters& parameters,
    MotionGenerator generator = MotionGenerator::weighted_ik);

// The motion of the parameters on the first approach that arrives at the goals, else the nearest
// motion; a motion that ends farther away is preferred to one whose foot slides.
[[nodiscard]] Arrival nearest_arrival(std::span<const ReachProblem> approaches,
                                      const Parameters& parameters,
                                      MotionGenerator generator = MotionGenerator::weighted_ik);

// The motion that the generator makes of the parameters.
[[nodiscard]] RolledOut play(const ReachProblem& problem, const Parameters& parameters,
                             MotionGenerator generator);

}  // namespace shigusa
