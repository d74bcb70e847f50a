// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/task.hpp>
#include <span>
#include <vector>

#include "planner.hpp"
#include "rollout/reachability.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {

// Ways to the goals, tried in this order until one leads there: a straight hand path; the same with
// the null space drawn to a posture that is known to arrive; that posture alone.
[[nodiscard]] std::vector<ReachProblem> approaches_to_goal(ReachProblem problem,
                                                           const ClosestReach& reach);

// The parameters' motion on the first way that brings them to the goal: the same parameters always
// give the same motion, whichever way they were found on.
[[nodiscard]] std::optional<Arrival> first_arrival(
    std::span<const ReachProblem> ways, const Parameters& parameters,
    MotionGenerator generator = MotionGenerator::weighted_ik);

// The same; where no way brings them to the goal, the motion that comes nearest, but rather one
// that is farther off than one whose foot slides.
[[nodiscard]] Arrival nearest_arrival(std::span<const ReachProblem> ways,
                                      const Parameters& parameters,
                                      MotionGenerator generator = MotionGenerator::weighted_ik);

// The parameters' motion as the generator makes it.
[[nodiscard]] RolledOut play(const ReachProblem& problem, const Parameters& parameters,
                             MotionGenerator generator);

}  // namespace shigusa
