// SPDX-License-Identifier: MIT
#include "explored.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

#include "core/index.hpp"
#include "core/say.hpp"
#include "problem/task_search.hpp"

namespace shigusa {

std::vector<Result<GenerateResult>> explore_all(std::span<const Task> tasks, int threads,
                                                const Progress& progress) {
  const auto works = [](const Task& task) { return !task.actions.empty(); };
  if (std::none_of(tasks.begin(), tasks.end(), works)) {
    return generate_all(tasks, threads, progress);
  }
  Progress quiet = progress;
  quiet.report = nullptr;
  std::atomic<int> done = 0;
  const auto caller = std::this_thread::get_id();
  std::vector<Result<GenerateResult>> made(tasks.size());
  parallel_for(static_cast<int>(tasks.size()), threads_for(tasks, threads), [&](int k, int) {
    if (quiet.cancelled()) {
      made[index(k)] = fail(ErrorCode::cancelled, say("stopped_before"));
    } else {
      made[index(k)] = perform(tasks[index(k)], quiet);
    }
    const double share = static_cast<double>(++done) / static_cast<double>(tasks.size());
    if (!progress.report || std::this_thread::get_id() != caller) return;
    progress.report({.stage = "work", .fraction = share});
  });
  return made;
}

}  // namespace shigusa
