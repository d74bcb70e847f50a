// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/layers/layered_player.hpp>
#include <shigusa/task/task.hpp>

namespace shigusa {

// The layers that a task goes by; fails on fixed parameters, which they do not know, and as
// plan_of does.
[[nodiscard]] Result<Plan> layers_of(const Task& task);

// The problem that a task poses to layers; points into the task. Fails where make_problem
// and layers_of do.
[[nodiscard]] Result<LayeredProblem> make_layered_problem(const Task& task);

}  // namespace shigusa
