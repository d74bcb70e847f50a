// SPDX-License-Identifier: MIT
#include "shard_statistics.hpp"

#include <span>
#include <vector>

#include "task_rows.hpp"

namespace shigusa {
namespace {

std::vector<std::string> names_of(std::span<const char* const> names) {
  return {names.begin(), names.end()};
}

}  // namespace

Result<void> add_shard_numbers(const ShardReader& shard, const DatasetPlan& plan,
                               DatasetStatistics& statistics, Table& splits) {
  SHG_TRY_ASSIGN(const std::vector<std::string> paths, shard.motion_tables());
  for (const std::string& path : paths) SHG_TRY(statistics.add_motions(shard, path));
  SHG_TRY_ASSIGN(const Table tasks, read_columns(shard, kTasksTable, names_of(kTaskColumns)));
  SHG_TRY_ASSIGN(const Table goals, read_columns(shard, kGoalsTable, names_of(kGoalColumns)));
  SHG_TRY_ASSIGN(const Table missed, read_columns(shard, kMissedTable, names_of(kMissedColumns)));
  SHG_TRY(check_tasks(tasks, shard.head(), shard_name(shard.head().shard)));
  add_splits(tasks, goals, plan.people() > 0, splits);
  statistics.add_tasks(tasks, splits);
  statistics.add_goals(goals);
  statistics.add_missed(missed);
  return {};
}

std::string format_statistics(const DatasetPlan& plan, const ShardList& shards,
                              const DatasetStatistics& statistics) {
  Json json{{"format", "shigusa data set, statistics"},
            {"version", kDatasetVersion},
            {"plan_sha256", plan.digest()},
            {"shards", shards.there.size()},
            {"missing_shards", shards.missing.size()}};
  json.update(json_of(statistics));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shigusa
