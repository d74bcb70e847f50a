// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/task.hpp>

#include "layers/layered_player.hpp"

namespace shigusa {

// The problem that a task poses to layers; points into the task. Fails where make_problem
// and plan_of do.
[[nodiscard]] Result<LayeredProblem> make_layered_problem(const Task& task);

}  // namespace shigusa
