// SPDX-License-Identifier: MIT
#include "stored_table.hpp"

#include <algorithm>

#include "shard_file.hpp"
#include "shard_form.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

Result<StoredTable> stored_table(const hdf5::Reader& reader, const std::string& path) {
  StoredTable stored{.names = {.path = path}, .columns = {}};
  SHG_TRY_ASSIGN(const hdf5::Object group, reader.object(path));
  for (const hdf5::Attribute& one : group.attributes) {
    SHG_TRY_ASSIGN(std::vector<std::string> list, hdf5::texts_of(group, one.name));
    stored.names.names.emplace_back(one.name, std::move(list));
  }
  std::sort(stored.names.names.begin(), stored.names.names.end());
  SHG_TRY_ASSIGN(const hdf5::Reader::Entries entries, reader.entries(group));
  Table columns = stored.names;
  for (const auto& [name, address] : entries) {
    SHG_TRY_ASSIGN(hdf5::StoredColumn column, reader.column(address, name));
    columns.columns.push_back(column.column);
    stored.columns.push_back(std::move(column));
  }
  SHG_TRY(check_form(columns));
  return stored;
}

// Paths of a shard's tables: those of tasks and their parts, then of motions.
Result<std::vector<std::string>> paths_in(const hdf5::Reader& reader) {
  std::vector<std::string> paths{kTasksTable, kGoalsTable, kObstaclesTable, kMissedTable};
  SHG_TRY_ASSIGN(const hdf5::Object root, reader.object("/"));
  SHG_TRY_ASSIGN(const hdf5::Reader::Entries all, reader.entries(root));
  const std::string motions = std::string(kMotionsGroup).substr(1);
  for (const auto& [name, address] : all) {
    if (name != motions) continue;
    SHG_TRY_ASSIGN(const hdf5::Object group, reader.object(kMotionsGroup));
    SHG_TRY_ASSIGN(const hdf5::Reader::Entries tables, reader.entries(group));
    for (const auto& [table, at] : tables)
      paths.push_back(std::string(kMotionsGroup) + "/" + table);
  }
  return paths;
}

}  // namespace

Result<StoredTables> stored_tables(const hdf5::Reader& reader) {
  SHG_TRY_ASSIGN(const std::vector<std::string> paths, paths_in(reader));
  StoredTables tables;
  std::uint64_t bytes = 0;
  for (const std::string& path : paths) {
    SHG_TRY_ASSIGN(StoredTable table, told_of(path, stored_table(reader, path)));
    // a file may declare the same bytes for many columns
    for (const hdf5::StoredColumn& one : table.columns) {
      bytes += one.rows * one.column.row_size();
      if (bytes <= reader.most_bytes() && bytes <= kShardFileMaxBytes * 4) continue;
      return fail(ErrorCode::parse, "has more bytes than a shard can have", path);
    }
    tables.emplace(path, std::move(table));
  }
  return tables;
}

}  // namespace shigusa
