// SPDX-License-Identifier: MIT
#include "data_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "shard_form.hpp"
#include "shard_list.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

template <class T>
T read_as(const Column& column, std::size_t place) {
  T value{};
  std::memcpy(&value, column.bytes.data() + place * sizeof(T), sizeof(T));
  return value;
}

std::size_t parts_of(const Column& column) { return column.row_size() / size_of(column.type); }

std::uint64_t whole_in(const Column& column, std::size_t row) {
  if (column.type == ElementType::u64) {
    return read_as<std::uint64_t>(column, row * parts_of(column));
  }
  const bool whole = column.type < ElementType::u64;
  const double number = whole ? number_in(column, row, 0) : 0.0;
  return number >= 0.0 ? static_cast<std::uint64_t>(number) : 0;
}

// Rows of a table by their task.
std::multimap<std::uint64_t, Row> by_task(const Table& table) {
  std::multimap<std::uint64_t, Row> rows;
  for (std::size_t at = 0; at < table.rows(); ++at) {
    const Row row{&table, at};
    rows.emplace(row.whole("task"), row);
  }
  return rows;
}

std::vector<Row> rows_of(const std::multimap<std::uint64_t, Row>& rows, std::uint64_t task) {
  std::vector<Row> found;
  const auto [first, last] = rows.equal_range(task);
  for (auto it = first; it != last; ++it) found.push_back(it->second);
  return found;
}

// Adds a task's and its goals' rows to each motion.
Result<void> join_motions(ShardRows& rows, std::size_t others, const std::string& place) {
  const auto table = rows.tables.begin();
  const auto tasks = by_task(*table);
  const auto goals = by_task(*std::next(table, 1));
  for (auto it = std::next(table, static_cast<std::ptrdiff_t>(others)); it != rows.tables.end();
       ++it) {
    for (std::size_t at = 0; at < it->rows(); ++at) {
      const Row motion{&*it, at};
      const std::uint64_t number = motion.whole("task");
      const auto task = tasks.find(number);
      if (task == tasks.end()) {
        return fail(ErrorCode::parse,
                    fmt::format("has a motion of task {}, which it has not", number), place);
      }
      rows.motions.push_back({motion, task->second, rows_of(goals, number)});
      const DataMotion& one = rows.motions.back();
      if (one.goals.size() > kMostOfTask) {
        return fail(ErrorCode::parse, fmt::format("has more than {} goals of a task", kMostOfTask),
                    place);
      }
    }
  }
  std::stable_sort(rows.motions.begin(), rows.motions.end(),
                   [](const DataMotion& a, const DataMotion& b) {
                     return std::pair(a.number(), a.rank()) < std::pair(b.number(), b.rank());
                   });
  const auto twice = std::adjacent_find(rows.motions.begin(), rows.motions.end(),
                                        [](const DataMotion& a, const DataMotion& b) {
                                          return a.number() == b.number() && a.rank() == b.rank();
                                        });
  if (twice == rows.motions.end()) return {};
  return fail(ErrorCode::parse, fmt::format("has the motion {} twice", twice->id()), place);
}

}  // namespace

double number_in(const Column& column, std::size_t row, std::size_t k) {
  const std::size_t parts = parts_of(column);
  if (k >= parts || row >= column.rows()) return kNoNumber;
  const std::size_t place = row * parts + k;
  switch (column.type) {
    case ElementType::u8:
      return read_as<std::uint8_t>(column, place);
    case ElementType::u16:
      return read_as<std::uint16_t>(column, place);
    case ElementType::u32:
      return read_as<std::uint32_t>(column, place);
    case ElementType::u64:
      return static_cast<double>(read_as<std::uint64_t>(column, place));
    case ElementType::f32:
      return static_cast<double>(read_as<float>(column, place));
    case ElementType::f64:
      return read_as<double>(column, place);
    case ElementType::text:
      break;
  }
  return kNoNumber;
}

double Row::number(std::string_view column, std::size_t k) const {
  const Column* found = table->find(column);
  return found == nullptr ? kNoNumber : number_in(*found, at, k);
}

std::uint64_t Row::whole(std::string_view column) const {
  const Column* found = table->find(column);
  return found == nullptr ? 0 : whole_in(*found, at);
}

Vec3d Row::point(std::string_view column) const {
  return {number(column, 0), number(column, 1), number(column, 2)};
}

std::vector<double> Row::numbers(std::string_view column) const {
  std::vector<double> all;
  const Column* found = table->find(column);
  if (found == nullptr || found->type == ElementType::text) return all;
  for (std::size_t k = 0; k < parts_of(*found); ++k) all.push_back(number_in(*found, at, k));
  return all;
}

std::string Row::text(std::string_view column) const {
  const Column* found = table->find(column);
  if (found == nullptr) return {};
  if (found->type != ElementType::text) {
    const std::uint64_t value = whole_in(*found, at);
    return value < found->words.size() ? found->words[value] : std::to_string(value);
  }
  const std::string_view padded(found->bytes.data() + at * found->row_size(), found->row_size());
  return std::string(padded.substr(0, padded.find('\0')));
}

std::string DataMotion::id() const { return fmt::format("{:06}-{}", number(), rank()); }

Result<DataFolder> DataFolder::open(const std::filesystem::path& folder) {
  SHG_TRY_ASSIGN(DatasetPlan plan, DatasetPlan::read(folder / kPlanName));
  DataFolder data{folder, std::move(plan), {}, 0};
  data.shards = list_shards(data.plan, folder).there;
  if (data.shards.empty()) {
    return fail(ErrorCode::not_found,
                fmt::format("has no shards ({} …): `shigusa dataset PLAN.json --out` this folder "
                            "makes them",
                            shard_name(0)),
                folder.string());
  }
  for (const std::uint64_t shard : data.shards) {
    const TaskRange tasks = data.plan.tasks_of(shard);
    data.tasks += tasks.last - tasks.first;
  }
  return data;
}

Split split_of(const DataMotion& motion, const DatasetPlan& plan) {
  const Row& task = motion.task;
  return split_of_person({.number = task.whole("person"),
                          .character = task.text("character"),
                          .sex = static_cast<std::uint8_t>(task.whole("sex")),
                          .stature_m = task.number("stature_m"),
                          .mass_kg = task.number("mass_kg")},
                         plan.people() > 0);
}

Result<ShardRows> read_rows(const DataFolder& data, std::uint64_t shard) {
  SHG_TRY_ASSIGN(const ShardReader reader, open_shard(data.plan, data.folder, shard));
  ShardRows rows;
  for (const char* path : {kTasksTable, kGoalsTable}) {
    SHG_TRY_ASSIGN(Table table, read_columns(reader, path, {}));
    rows.tables.push_back(std::move(table));
  }
  SHG_TRY(check_tasks(rows.tables.front(), reader.head(), shard_name(shard)));
  const std::size_t others = rows.tables.size();
  SHG_TRY_ASSIGN(const std::vector<std::string> paths, reader.motion_tables());
  for (const std::string& path : paths) {
    SHG_TRY_ASSIGN(const Table empty, reader.table(path, {}, {0, 0}));
    std::vector<std::string> names;
    for (const Column& column : empty.columns) {
      if (column.shape.size() <= 1) names.push_back(column.name);
    }
    SHG_TRY_ASSIGN(Table table, read_columns(reader, path, names));
    rows.tables.push_back(std::move(table));
  }
  SHG_TRY(join_motions(rows, others, shard_name(shard)));
  return rows;
}

}  // namespace shigusa
