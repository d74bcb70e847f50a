// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/task/task.hpp>
#include <vector>

#include "io/json_reader.hpp"

namespace shigusa {

[[nodiscard]] Json goal_to_json(const Goal& goal);

// Adds a task's goals, one for each effector; what is wrong is told to the reader.
void read_goals(JsonReader& task, std::vector<Goal>& goals);

}  // namespace shigusa
