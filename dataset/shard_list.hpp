// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <shigusa/dataset.hpp>
#include <string>
#include <vector>

#include "shard_file.hpp"

namespace shigusa {

// Shards of a plan in a folder, by their names.
struct ShardList {
  std::vector<std::uint64_t> there;    // numbers, in their order
  std::vector<std::uint64_t> missing;  // the same
  std::vector<std::string> foreign;    // files with a shard's name that the plan has not, sorted
};
[[nodiscard]] ShardList list_shards(const DatasetPlan& plan, const std::filesystem::path& folder);

// A shard of a plan opened for reading. Fails on a file with another checksum, and on a shard of
// another plan or position.
[[nodiscard]] Result<ShardReader> open_shard(const DatasetPlan& plan,
                                             const std::filesystem::path& folder,
                                             std::uint64_t shard);

// Columns of a table, all with the same number of rows.
[[nodiscard]] Result<Table> read_columns(const ShardReader& shard, const std::string& path,
                                         const std::vector<std::string>& columns);

// Fails unless a table of tasks has one row per task of the shard, in order.
[[nodiscard]] Result<void> check_tasks(const Table& tasks, const ShardHead& head,
                                       const std::string& place);

// Whether two tables have the same columns and lists of names, whatever their rows.
[[nodiscard]] bool same_columns(const Table& a, const Table& b);

// Paths of all tables of a shard: of tasks and their parts, then of motions.
[[nodiscard]] Result<std::vector<std::string>> paths_of(const ShardReader& shard);

}  // namespace shigusa
