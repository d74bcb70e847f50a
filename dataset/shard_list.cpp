// SPDX-License-Identifier: MIT
#include "shard_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "files/folder.hpp"
#include "shard_form.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

constexpr std::string_view kBegin = "shard-";
constexpr std::string_view kEnd = ".h5";

// Number in a shard's name; empty for other names.
std::optional<std::uint64_t> number_in(const std::string& name) {
  if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) return std::nullopt;
  std::uint64_t number = 0;
  const char* const end = name.data() + name.size() - kEnd.size();
  const auto [stop, code] = std::from_chars(name.data() + kBegin.size(), end, number);
  if (code != std::errc{} || stop != end || shard_name(number) != name) return std::nullopt;
  return number;
}

}  // namespace

ShardList list_shards(const DatasetPlan& plan, const std::filesystem::path& folder) {
  ShardList list;
  const Descriptor here = open_folder(folder);
  if (!here) return list;
  for (const std::string& name : names_in(here)) {
    const auto number = number_in(name);
    if (!number) continue;
    if (*number < plan.shards()) {
      list.there.push_back(*number);
    } else {
      list.foreign.push_back(name);
    }
  }
  std::sort(list.there.begin(), list.there.end());
  std::sort(list.foreign.begin(), list.foreign.end());
  auto next = list.there.begin();
  for (std::uint64_t shard = 0; shard < plan.shards(); ++shard) {
    if (next != list.there.end() && *next == shard) {
      ++next;
    } else {
      list.missing.push_back(shard);
    }
  }
  return list;
}

Result<ShardReader> open_shard(const DatasetPlan& plan, const std::filesystem::path& folder,
                               std::uint64_t shard) {
  const std::filesystem::path path = folder / shard_name(shard);
  SHG_TRY_ASSIGN(ShardReader reader, ShardReader::open(path));
  const ShardHead& head = reader.head();
  const TaskRange tasks = plan.tasks_of(shard);
  if (head.plan != plan.digest()) {
    return fail(ErrorCode::parse,
                fmt::format("is a shard of another plan: its digest is {}, that of {} is {}",
                            head.plan, kPlanName, plan.digest()),
                path.string());
  }
  if (head.shard != shard || head.tasks.first != tasks.first || head.tasks.last != tasks.last) {
    return fail(ErrorCode::parse,
                fmt::format("is shard {} with tasks {} to {}; in its place the plan has shard {} "
                            "with tasks {} to {}: make the data set again, which replaces it",
                            head.shard, head.tasks.first, head.tasks.last - 1, shard, tasks.first,
                            tasks.last - 1),
                path.string());
  }
  return reader;
}

Result<Table> read_columns(const ShardReader& shard, const std::string& path,
                           const std::vector<std::string>& columns) {
  SHG_TRY_ASSIGN(Table table, shard.table(path, columns));
  for (const Column& column : table.columns) {
    if (column.row_size() > 0 && column.rows() == table.rows()) continue;
    return fail(ErrorCode::parse, "has columns of unlike length",
                shard_name(shard.head().shard) + ": " + path);
  }
  return table;
}

Result<void> check_tasks(const Table& tasks, const ShardHead& head, const std::string& place) {
  const auto numbers = tasks.find("task")->as<std::uint64_t>();
  bool whole = numbers.size() == head.tasks.last - head.tasks.first;
  for (std::size_t k = 0; whole && k < numbers.size(); ++k) {
    whole = numbers[k] == head.tasks.first + k;
  }
  if (whole) return {};
  return fail(ErrorCode::parse, "has other tasks than its head tells", place);
}

bool same_columns(const Table& a, const Table& b) {
  if (a.columns.size() != b.columns.size() || a.names != b.names) return false;
  return std::all_of(a.columns.begin(), a.columns.end(), [&b](const Column& column) {
    const Column* other = b.find(column.name);
    return other != nullptr && same_column(column, *other);
  });
}

Result<std::vector<std::string>> paths_of(const ShardReader& shard) {
  std::vector<std::string> paths{kTasksTable, kGoalsTable, kObstaclesTable, kMissedTable};
  SHG_TRY_ASSIGN(const std::vector<std::string> motions, shard.motion_tables());
  paths.insert(paths.end(), motions.begin(), motions.end());
  return paths;
}

}  // namespace shigusa
