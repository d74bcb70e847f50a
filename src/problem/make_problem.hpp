// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>

#include "rollout/reach_problem.hpp"

namespace shigusa {

// The problem of a task for the search: paths from the start posture to the goals, and their
// duration. Fails with a message that names the goal and the allowed values: for an unknown
// effector (with the nearest name), two goals for one effector, coordinates that are not finite or
// beyond kGoalRange, no goal at all, a duration outside 0.05 to 60 s, criteria weights below 0 or
// all 0, a second phase, a load, an obstacle, a rotation, an axis or a box out of range, or more
// goals than kMaxIkRows allows. The problem refers to the task.
[[nodiscard]] Result<ReachProblem> make_problem(const Task& task);

}  // namespace shigusa
