// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/task.hpp>

namespace shigusa {

// Runs the search that the task names. A genetic one by the task's own settings: once until it
// converges where `once` is set, else again and again until `evaluations` are used up.
[[nodiscard]] SearchResult run_search(const Task& task, const SearchProblem& problem,
                                      int evaluations, bool once, const Progress& progress);

}  // namespace shigusa
