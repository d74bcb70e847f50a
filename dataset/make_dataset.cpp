// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <shigusa/dataset.hpp>

#include "files/file.hpp"
#include "files/staging.hpp"
#include "shard_file.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

using Clock = std::chrono::steady_clock;

// Shards of a plan to be made.
struct Making {
  const DatasetPlan& plan;
  const DatasetSettings& settings;
  Clock::time_point begin = Clock::now();
  std::uint64_t tasks = 0;  // of all that are to be made
  DatasetRun run{};

  void tell() const {
    if (!settings.report) return;
    settings.report({.tasks = run.tasks,
                     .motions = run.motions,
                     .of = tasks,
                     .seconds = std::chrono::duration<double>(Clock::now() - begin).count()});
  }
};

ShardHead head_of(const DatasetPlan& plan, std::uint64_t shard) {
  return {.plan = plan.digest(), .shard = shard, .tasks = plan.tasks_of(shard)};
}

// Whether the shard exists. Fails if it is of another plan.
Result<bool> is_there(const DatasetPlan& plan, const std::filesystem::path& folder,
                      std::uint64_t shard) {
  const std::filesystem::path path = folder / shard_name(shard);
  SHG_TRY_ASSIGN(const std::optional<ShardHead> head, read_head(path));
  if (!head) return false;
  if (head->plan != plan.digest()) {
    return fail(ErrorCode::invalid_argument,
                "is a shard of another plan: give another folder, or move that one away",
                path.string());
  }
  // the last shard of a previously shorter plan is made again
  return same_place(*head, head_of(plan, shard));
}

// Makes the tasks of a shard in parallel, and collects their rows in task order.
std::vector<Table> shard_tables(Making& work, std::uint64_t shard) {
  std::vector<Table> tables = empty_tables();
  const TaskRange range = work.plan.tasks_of(shard);
  const int threads = thread_count(work.settings.threads);
  // a few per thread: the slowest of them is waited for
  const std::uint64_t batch = 8 * static_cast<std::uint64_t>(threads);
  for (std::uint64_t first = range.first; first < range.last; first += batch) {
    const auto count = std::min(batch, range.last - first);
    std::vector<std::optional<MadeTask>> made(count);
    parallel_for(static_cast<int>(count), threads, [&](int k, int) {
      const auto i = static_cast<std::size_t>(k);
      made[i] = make_task_rows(work.plan, first + i, work.settings.simd);
    });
    for (std::optional<MadeTask>& one : made) {
      ++work.run.tasks;
      work.run.motions += one->motions;
      work.run.search_seconds += one->search_seconds;
      work.run.thread_seconds += one->seconds;
      append(std::move(one->tables), tables);
    }
    work.tell();
  }
  // rarely drawn bodies occur in another order in each shard
  std::sort(tables.begin(), tables.end(),
            [](const Table& a, const Table& b) { return a.path < b.path; });
  return tables;
}

Result<void> make_shard(Making& work, std::uint64_t shard) {
  const std::filesystem::path& folder = work.settings.folder;
  const std::vector<Table> tables = shard_tables(work, shard);
  SHG_TRY_ASSIGN(const std::string bytes,
                 format_shard(head_of(work.plan, shard), work.plan.text(), tables));
  const std::string name = shard_name(shard);
  Staging staging;
  int reason = staging.open(folder);
  if (reason != 0) return refused(folder, "open", reason);
  reason = staging.make();
  if (reason == 0) reason = staging.add(name, bytes, true);
  if (reason == 0) reason = staging.move_out(name, name);
  if (reason == 0) reason = settle(staging.folder());
  if (reason != 0) return refused(folder / name, "write", reason);
  ++work.run.made;
  return {};
}

}  // namespace

std::string shard_name(std::uint64_t shard) { return fmt::format("shard-{:06}.h5", shard); }

Result<void> keep_plan(const DatasetPlan& plan, const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kPlanName;
  std::error_code failed;
  if (std::filesystem::exists(path, failed)) {
    SHG_TRY_ASSIGN(const DatasetPlan other, DatasetPlan::read(path));
    if (other.digest() != plan.digest()) {
      return fail(ErrorCode::invalid_argument,
                  "is another plan: a folder has the data of one alone", path.string());
    }
    // only the number of tasks may differ: the larger one is kept
    if (other.tasks() >= plan.tasks()) return {};
  }
  return write_file(path, plan.text_in(folder));
}

Result<DatasetRun> make_dataset(const DatasetPlan& plan, const DatasetSettings& settings) {
  Making work{plan, settings};
  const std::uint64_t last = std::min(plan.shards(), settings.last_shard.value_or(plan.shards()));
  std::vector<std::uint64_t> missing;
  for (std::uint64_t shard = settings.first_shard; shard < last; ++shard) {
    SHG_TRY_ASSIGN(const bool there, is_there(plan, settings.folder, shard));
    if (there) {
      ++work.run.there;
      continue;
    }
    missing.push_back(shard);
    const TaskRange tasks = plan.tasks_of(shard);
    work.tasks += tasks.last - tasks.first;
  }
  remove_leftovers(open_folder(settings.folder));
  work.tell();
  for (const std::uint64_t shard : missing) {
    if (settings.cancel != nullptr && settings.cancel->load()) break;
    // another program may have made it in the meantime
    SHG_TRY_ASSIGN(const bool there, is_there(plan, settings.folder, shard));
    if (there) {
      ++work.run.there;
      continue;
    }
    SHG_TRY(make_shard(work, shard));
  }
  const std::uint64_t asked = last > settings.first_shard ? last - settings.first_shard : 0;
  work.run.left = asked - work.run.made - work.run.there;
  work.run.seconds = std::chrono::duration<double>(Clock::now() - work.begin).count();
  return work.run;
}

}  // namespace shigusa
