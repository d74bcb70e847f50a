// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <shigusa/request.hpp>
#include <span>

#include "problem.hpp"

namespace shigusa {

// The settings in which searches of one problem differ.
struct RunSettings {
  CriteriaSettings criteria;         // the problem's, or with other weights
  std::optional<int> evaluations{};  // motions; none: usual_evaluations
  std::uint64_t seed = 0;
  std::uint64_t stream = 0;  // of the genetic algorithm
};

// The run that a task asks for.
[[nodiscard]] RunSettings run_of(const Problem& problem);

// Runs the search that the task names. A genetic one uses the task's own settings: a single run
// until it converges if `once` is set, else repeated runs until `evaluations` are used up.
[[nodiscard]] SearchResult run_search(const Task& task, const RunSettings& run,
                                      const SearchProblem& problem, int evaluations, bool once,
                                      const Progress& progress);

// Threads on which tasks are worked on side by side: user criteria are called from one.
[[nodiscard]] inline int threads_for(std::span<const Task> tasks, int threads) {
  const auto own = [](const Task& task) { return !task.criteria.user.empty(); };
  return std::any_of(tasks.begin(), tasks.end(), own) ? 1 : threads;
}

}  // namespace shigusa
