// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <shigusa/dataset_merge.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "data_card.hpp"
#include "files/file.hpp"
#include "hdf5.hpp"
#include "index_writer.hpp"
#include "shard_list.hpp"
#include "shard_statistics.hpp"
#include "splits.hpp"
#include "statistics.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

using Clock = std::chrono::steady_clock;

// Rows of a table in a shard.
struct Part {
  std::uint32_t shard = 0;
  std::uint32_t rows = 0;
};

// A table of all shards.
struct WholeTable {
  Table columns;  // without rows
  std::vector<Part> parts;
};

// A merge in progress.
struct Merge {
  const DatasetPlan& plan;
  const std::filesystem::path& folder;
  const MergeSettings& settings;
  ShardList shards;
  std::map<std::string, WholeTable> tables{};  // by their paths
  DatasetStatistics statistics{};
  std::string axes{};  // as the shards have them

  [[nodiscard]] bool mapped() const { return shards.there.size() <= kMostMappedShards; }
};

Table shards_table() {
  return {kShardsTable,
          {{.name = "shard", .type = ElementType::u64, .says = "number of the shard"},
           {.name = "first_task", .type = ElementType::u64},
           {.name = "last_task", .type = ElementType::u64, .says = "the one after the last"},
           {.name = "motions", .type = ElementType::u64},
           {.name = "bytes", .type = ElementType::u64, .says = "of the file"},
           {.name = "sha256",
            .type = ElementType::text,
            .says = "as the file's head has it",
            .text_size = kSumSize}}};
}

// Whether a table of tasks, or of their parts, has exactly the columns that this program writes.
bool is_known(const Table& table) {
  for (const Table& known : empty_tables()) {
    if (known.path == table.path) return same_columns(known, table);
  }
  return true;
}

// Records a shard's rows of a table; returns their number.
Result<std::size_t> note_table(Merge& merge, const ShardReader& shard, const std::string& path) {
  const std::uint64_t number = shard.head().shard;
  SHG_TRY_ASSIGN(Table columns, shard.table(path, {}, {0, 0}));
  const auto [known, added] = merge.tables.try_emplace(path);
  if (added) known->second.columns = columns;
  if (!is_known(columns) || !same_columns(known->second.columns, columns)) {
    return fail(ErrorCode::parse,
                "has other columns than this program writes, or than the shards before it",
                (merge.folder / shard_name(number)).string() + ": " + path);
  }
  SHG_TRY_ASSIGN(const Table tasks, read_columns(shard, path, {"task"}));
  if (tasks.rows() > 0) {
    known->second.parts.push_back(
        {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(tasks.rows())});
  }
  return tasks.rows();
}

// Reads a shard: its checksum, its statistics, its splits.
Result<void> add_shard(Merge& merge, std::uint64_t number, RowWriter& shards, RowWriter& splits) {
  SHG_TRY_ASSIGN(const ShardReader shard, open_shard(merge.plan, merge.folder, number));
  SHG_TRY_ASSIGN(const std::vector<std::string> paths, paths_of(shard));
  std::uint64_t motions = 0;
  for (const std::string& path : paths) {
    SHG_TRY_ASSIGN(const std::size_t rows, note_table(merge, shard, path));
    if (!path.starts_with(kMotionsGroup)) continue;
    motions += rows;
  }
  Table parts = splits_table();
  SHG_TRY(add_shard_numbers(shard, merge.plan, merge.statistics, parts));
  splits.add(parts);
  SHG_TRY(splits.flush());
  if (merge.axes.empty()) {
    SHG_TRY_ASSIGN(merge.axes, shard.axes());
  }
  std::error_code failed;
  Table& row = shards.rows();
  row["shard"].push_as(number);
  row["first_task"].push_as(shard.head().tasks.first);
  row["last_task"].push_as(shard.head().tasks.last);
  row["motions"].push_as(motions);
  row["bytes"].push_as(
      std::uint64_t{std::filesystem::file_size(merge.folder / shard_name(number), failed)});
  row["sha256"].push(std::string_view(shard.head().sha256));
  return shards.flush();
}

Result<void> write_names(const hdf5::Handle& group, const Table& table) {
  for (const auto& [what, list] : table.names) {
    SHG_TRY(hdf5::write_texts(group, what.c_str(), list));
  }
  return {};
}

Result<void> write_merged(const hdf5::Handle& file, const Table& table) {
  SHG_TRY_ASSIGN(const hdf5::Handle group, hdf5::create_group(file, table.path));
  SHG_TRY(write_names(group, table));
  for (const Column& column : table.columns) SHG_TRY(hdf5::write_column(group, column));
  return {};
}

// A table of virtual datasets.
Result<void> write_whole(const hdf5::Handle& file, const WholeTable& table) {
  SHG_TRY_ASSIGN(const hdf5::Handle group, hdf5::create_group(file, table.columns.path));
  SHG_TRY(write_names(group, table.columns));
  std::vector<hdf5::VirtualPart> parts;
  for (const Part& part : table.parts) parts.push_back({shard_name(part.shard), "", part.rows});
  for (const Column& column : table.columns.columns) {
    for (hdf5::VirtualPart& part : parts) part.dataset = table.columns.path + "/" + column.name;
    SHG_TRY(hdf5::write_virtual_column(group, column, parts));
  }
  return {};
}

// Numbers of rows per shard and table, by which readers find the shard of a row.
Result<void> write_row_counts(const hdf5::Handle& group, const Merge& merge) {
  Table table;
  table.columns = {{.name = "rows",
                    .type = ElementType::u32,
                    .shape = {merge.tables.size()},
                    .says = "that the shard has of each of `tables`"}};
  SHG_TRY_ASSIGN(RowWriter writer, RowWriter::create(group, table, merge.shards.there.size()));
  std::vector<const Part*> next;
  std::vector<const Part*> ends;
  for (const auto& [path, whole] : merge.tables) {
    next.push_back(whole.parts.data());
    ends.push_back(whole.parts.data() + whole.parts.size());
  }
  for (const std::uint64_t shard : merge.shards.there) {
    for (std::size_t k = 0; k < next.size(); ++k) {
      const bool has = next[k] != ends[k] && next[k]->shard == shard;
      writer.rows()["rows"].push_as(has ? (next[k]++)->rows : std::uint32_t{0});
    }
    SHG_TRY(writer.flush());
  }
  return writer.flush(true);
}

Result<void> write_root(const hdf5::Handle& file, const Merge& merge) {
  const hdf5::Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose);
  SHG_TRY(hdf5::write_text(root, "format", "shigusa data set, index"));
  SHG_TRY(hdf5::write_number(root, "version", kDatasetVersion));
  SHG_TRY(hdf5::write_text(root, "plan_sha256", merge.plan.digest()));
  SHG_TRY(hdf5::write_number(root, "shards", merge.shards.there.size()));
  SHG_TRY(hdf5::write_number(root, "missing_shards", merge.shards.missing.size()));
  return hdf5::write_text(root, "axes", merge.axes);
}

Result<void> write_rule(const hdf5::Handle& group, bool numbered) {
  SHG_TRY(hdf5::write_text(
      group, "person",
      numbered ? "the number that the plan's people have"
               : "character, sex, stature to the centimetre and mass to the kilogram"));
  SHG_TRY(hdf5::write_text(group, "drawn", "by a hash of the person, or of the region"));
  for (std::size_t k = 0; k < kSplitPercent.size(); ++k) {
    const std::string name = fmt::format("{}_percent", kEnumWords<Split>[k].word);
    SHG_TRY(hdf5::write_number(group, name.c_str(), static_cast<std::uint64_t>(kSplitPercent[k])));
  }
  return {};
}

// Reads all shards and writes the tables whose size is proportional to them.
Result<void> read_shards(Merge& merge, const hdf5::Handle& file) {
  SHG_TRY_ASSIGN(const hdf5::Handle list, hdf5::create_group(file, kShardsTable));
  SHG_TRY_ASSIGN(const hdf5::Handle parts, hdf5::create_group(file, kSplitsTable));
  SHG_TRY(write_rule(parts, merge.plan.people() > 0));
  std::uint64_t tasks = 0;
  for (const std::uint64_t shard : merge.shards.there) {
    tasks += merge.plan.tasks_of(shard).last - merge.plan.tasks_of(shard).first;
  }
  SHG_TRY_ASSIGN(RowWriter shards,
                 RowWriter::create(list, shards_table(), merge.shards.there.size()));
  SHG_TRY_ASSIGN(RowWriter splits, RowWriter::create(parts, splits_table(), tasks));
  MergeReport report{.of = merge.shards.there.size()};
  for (const std::uint64_t shard : merge.shards.there) {
    if (merge.settings.cancel != nullptr && merge.settings.cancel->load()) {
      return fail(ErrorCode::cancelled, "is stopped: the index is as it was",
                  merge.folder.string());
    }
    SHG_TRY(add_shard(merge, shard, shards, splits));
    ++report.shards;
    if (merge.settings.report) merge.settings.report(report);
  }
  SHG_TRY(shards.flush(true));
  SHG_TRY(splits.flush(true));
  SHG_TRY(write_row_counts(list, merge));
  std::vector<std::string> paths;
  for (const auto& [path, whole] : merge.tables) paths.push_back(path);
  return hdf5::write_texts(list, "tables", paths);
}

Result<void> write_index(Merge& merge, const hdf5::Handle& file) {
  SHG_TRY(read_shards(merge, file));
  SHG_TRY(write_root(file, merge));
  for (const Table& table : tables_of(merge.statistics)) SHG_TRY(write_merged(file, table));
  for (const auto& [path, whole] : merge.tables) {
    if (merge.mapped()) SHG_TRY(write_whole(file, whole));
  }
  return {};
}

std::string card_text(const Merge& merge) {
  std::vector<Table> motions;
  for (const auto& [path, whole] : merge.tables) {
    if (path.starts_with(kMotionsGroup)) motions.push_back(whole.columns);
  }
  return format_card({.plan = merge.plan,
                      .program = merge.settings.program,
                      .motions = motions,
                      .statistics = &merge.statistics,
                      .missing = merge.shards.missing.size(),
                      .mapped = merge.mapped(),
                      .first_shard = merge.shards.there.front()});
}

}  // namespace

Result<MergeRun> merge_dataset(const std::filesystem::path& folder, const MergeSettings& settings) {
  const Clock::time_point begin = Clock::now();
  SHG_TRY_ASSIGN(const DatasetPlan plan, DatasetPlan::read(folder / kPlanName));
  Merge merge{
      .plan = plan, .folder = folder, .settings = settings, .shards = list_shards(plan, folder)};
  if (merge.shards.there.empty()) {
    return fail(ErrorCode::not_found,
                fmt::format("has no shard yet: make them first, such as {}", shard_name(0)),
                folder.string());
  }
  SHG_TRY_ASSIGN(IndexFile index, IndexFile::create(folder / kIndexName));
  SHG_TRY(write_index(merge, index.file()));
  SHG_TRY(write_file(folder / kStatisticsName,
                     format_statistics(merge.plan, merge.shards, merge.statistics)));
  SHG_TRY(write_file(folder / kCardName, card_text(merge)));
  MergeRun run{.shards = merge.shards.there.size(),
               .missing = std::move(merge.shards.missing),
               .tasks = merge.statistics.tasks,
               .motions = merge.statistics.motions,
               .mapped = merge.mapped()};
  SHG_TRY_ASSIGN(run.bytes, index.finish({.plan = plan.digest(), .shards = run.shards}));
  run.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return run;
}

Result<void> write_first_card(const DatasetPlan& plan, const std::filesystem::path& folder,
                              const std::string& program) {
  const std::filesystem::path path = folder / kCardName;
  std::error_code failed;
  if (std::filesystem::exists(path, failed)) return {};
  const std::vector<Table> motions = planned_tables(plan);
  return write_file(path, format_card({.plan = plan, .program = program, .motions = motions}));
}

}  // namespace shigusa
