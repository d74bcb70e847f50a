// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/generate.hpp>

#include "rollout/reach_problem.hpp"

namespace shigusa {

// The task mirrored in the sagittal plane, without user criteria.
[[nodiscard]] Task mirrored_task(Task task);

// The mirror image of a motion of the body, with its effectors at the problem's goals. None if the
// body is not symmetric, or its start posture is not.
[[nodiscard]] std::optional<Motion> reflection(const ReachProblem& problem, const Motion& of);

}  // namespace shigusa
