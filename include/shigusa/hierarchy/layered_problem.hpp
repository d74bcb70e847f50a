// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/hierarchy/layered_player.hpp>
#include <shigusa/hierarchy/task.hpp>

namespace shigusa {

// The problem that a task poses to layers; points into the task. Fails where make_problem does, and
// on a body that is not a person's (find_limbs).
[[nodiscard]] Result<LayeredProblem> make_layered_problem(const Task& task);

}  // namespace shigusa
