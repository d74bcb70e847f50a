// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/generate.hpp>

#include "core/index.hpp"
#include "core/say.hpp"
#include "joint_progress.hpp"
#include "problem/task_search.hpp"

namespace shigusa {
namespace {

// Generates one task of many. Its part of the progress ends where it ends.
Result<GenerateResult> generate_one(Task task, int threads, const Progress& part) {
  if (part.cancelled()) return fail(ErrorCode::cancelled, say("stopped_before"));
  task.batch.threads = threads;
  Result<GenerateResult> made = generate(task, part);
  if (!part.report) return made;
  ProgressReport end{.stage = "search", .fraction = 1.0};
  if (made) {
    end.evaluations = made->log.evaluations;
    end.best_score = made->candidates.front().score.total;
  }
  part.report(end);
  return made;
}

}  // namespace

std::vector<Result<GenerateResult>> generate_all(std::span<const Task> tasks, int threads,
                                                 const Progress& progress) {
  const int count = static_cast<int>(tasks.size());
  threads = threads_for(tasks, threads);
  // of fewer tasks than threads each has several
  const int each = std::max(1, thread_count(threads) / std::max(1, count));
  JointProgress joint(progress);
  std::vector<Progress> parts;
  for (int k = 0; k < count; ++k) parts.push_back(joint.part(1.0 / count));
  std::vector<Result<GenerateResult>> made(tasks.size());
  parallel_for(count, threads, [&](int k, int) {
    made[index(k)] = generate_one(tasks[index(k)], each, parts[index(k)]);
  });
  return made;
}

}  // namespace shigusa
