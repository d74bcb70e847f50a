// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <memory>
#include <shigusa/dataset.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "shard_file.hpp"
#include "splits.hpp"
#include "table.hpp"

namespace shigusa {

// A row of a table. Borrows the table.
struct Row {
  const Table* table = nullptr;
  std::size_t at = 0;

  // Part `k` of a column's number; NaN if the table has no such column or part.
  [[nodiscard]] double number(std::string_view column, std::size_t k = 0) const;
  // The same for a column of whole numbers; 0 if absent.
  [[nodiscard]] std::uint64_t whole(std::string_view column) const;
  [[nodiscard]] Vec3d point(std::string_view column) const;
  // All numbers of a column; empty if absent.
  [[nodiscard]] std::vector<double> numbers(std::string_view column) const;
  // Text of a column, or the word of its number.
  [[nodiscard]] std::string text(std::string_view column) const;
};

// Part `k` of a column's number in a row.
[[nodiscard]] double number_in(const Column& column, std::size_t row, std::size_t k = 0);

// A motion with its associated rows.
struct DataMotion {
  Row motion;
  Row task;
  std::vector<Row> goals;

  [[nodiscard]] std::uint64_t number() const { return task.whole("task"); }
  [[nodiscard]] std::uint64_t rank() const { return motion.whole("rank"); }
  // Name from task number and rank, "000012-1"; names sort in the order of tasks.
  [[nodiscard]] std::string id() const;
};

// Rows of a shard, or of some of its columns.
struct ShardRows {
  // a list, as rows point to its tables
  std::list<Table> tables;
  std::vector<DataMotion> motions;  // by task, then by rank
};

// Folder of a data set: its plan, and its existing shards.
struct DataFolder {
  std::filesystem::path folder;
  DatasetPlan plan;
  std::vector<std::uint64_t> shards;  // numbers, in their order
  std::uint64_t tasks = 0;            // of these shards

  // Opens a folder; fails without a plan or shards.
  [[nodiscard]] static Result<DataFolder> open(const std::filesystem::path& folder);
};

// Reads a shard's tables of tasks and goals, and of motions the columns of single numbers and
// lists.
[[nodiscard]] Result<ShardRows> read_rows(const DataFolder& data, std::uint64_t shard);

// Part of the data set of a motion, by its person.
[[nodiscard]] Split split_of(const DataMotion& motion, const DatasetPlan& plan);

}  // namespace shigusa
