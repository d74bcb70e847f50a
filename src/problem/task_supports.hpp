// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>
#include <vector>

#include "kinematics/forward_kinematics.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Half the thickness (m) of a hand, at its thin end.
[[nodiscard]] double half_thickness(const BodyModel& body, const Effector& hand);

// Fails if the request's preset or generator does not support its supports.
[[nodiscard]] Result<void> check_supports(const Request& request);

// The supports of a task's hands, from the body's start posture. On an obstacle each is at a
// provisional place on its surface until settle_supports finds the one in reach. Fails for hands
// that the body lacks, that have a goal or two supports, and for unknown places.
[[nodiscard]] Result<std::vector<HandSupport>> make_supports(const Task& task,
                                                             const Kinematics<double>& start);

// The places touched by resting hands, for the criterion collision; none for invalid supports.
[[nodiscard]] std::vector<RestingPlace> resting_places(const Task& task);

// Finds the places on obstacles, and the earliest arrival of the hands. Fails if a hand does not
// reach its place while the goals are met.
[[nodiscard]] Result<void> settle_supports(const Task& task, ReachProblem& problem);

}  // namespace shigusa
