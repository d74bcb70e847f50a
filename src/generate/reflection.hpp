// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/generate.hpp>

#include "rollout/reach_problem.hpp"

namespace shigusa {

// The task on the other side of the body's middle, without criteria of the user's own.
[[nodiscard]] Task mirrored_task(Task task);

// The mirror image of a motion of the body, its effectors at the problem's goals. None of a body
// that is not alike on both sides, or does not stand so at the start.
[[nodiscard]] std::optional<Motion> reflection(const ReachProblem& problem, const Motion& of);

}  // namespace shigusa
