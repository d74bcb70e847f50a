// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>
#include <vector>

#include "kinematics/forward_kinematics.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Half the thickness (m) of a hand, at its thin end.
[[nodiscard]] double half_thickness(const BodyModel& body, const Effector& hand);

// Fails on supports that the request's preset or generator does not know.
[[nodiscard]] Result<void> check_supports(const Request& request);

// The supports of a task's hands, from the body's start posture. On an obstacle each is at some
// place of its surface until settle_supports finds the one that the hand reaches. Fails on hands
// that the body has not, that have a goal or two supports, and on places that are not there.
[[nodiscard]] Result<std::vector<HandSupport>> make_supports(const Task& task,
                                                             const Kinematics<double>& start);

// The places that resting hands touch, for the criterion collision; of wrong supports none.
[[nodiscard]] std::vector<RestingPlace> resting_places(const Task& task);

// Finds the places on obstacles, and how early the hands arrive. Fails where a hand does not reach
// its place while the goals are met.
[[nodiscard]] Result<void> settle_supports(const Task& task, ReachProblem& problem);

}  // namespace shigusa
