// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>
#include <span>
#include <vector>

namespace shigusa {

// Generates or, of tasks with actions, performs, as generate_all does.
[[nodiscard]] std::vector<Result<GenerateResult>> explore_all(std::span<const Task> tasks,
                                                              int threads,
                                                              const Progress& progress);

}  // namespace shigusa
