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

  // Part `k` of the number in a column; NaN where the table has no such column or part.
  [[nodiscard]] double number(std::string_view column, std::size_t k = 0) const;
  // The same of a column of whole numbers, 0 without one.
  [[nodiscard]] std::uint64_t whole(std::string_view column) const;
  [[nodiscard]] Vec3d point(std::string_view column) const;
  // The numbers of a column, none where the table has it not.
  [[nodiscard]] std::vector<double> numbers(std::string_view column) const;
  // A column's text, or the word that its number stands for.
  [[nodiscard]] std::string text(std::string_view column) const;
};

// Part `k` of a column's number in a row.
[[nodiscard]] double number_in(const Column& column, std::size_t row, std::size_t k = 0);

// A motion with what belongs to it.
struct DataMotion {
  Row motion;
  Row task;
  std::vector<Row> goals;
  std::vector<Row> obstacles;

  [[nodiscard]] std::uint64_t number() const { return task.whole("task"); }
  [[nodiscard]] std::uint64_t rank() const { return motion.whole("rank"); }
  // The posture at the end.
  [[nodiscard]] FinalPosture ends() const;
  // "000012-1": its task's number and its rank; names sort as tasks do.
  [[nodiscard]] std::string id() const;
};

// The rows of a shard, or of some of its columns.
struct ShardRows {
  ShardHead head;
  // a list, so that rows may point to its tables
  std::list<Table> tables;
  std::vector<DataMotion> motions;  // by task, then by rank
  const Table* tasks = nullptr;
};

// A data set's folder: its plan, and the shards of it that are there.
struct DataFolder {
  std::filesystem::path folder;
  DatasetPlan plan;
  std::vector<std::uint64_t> shards;  // numbers, in their order
  std::uint64_t tasks = 0;            // of these shards

  // Fails where there is no plan or no shard.
  [[nodiscard]] static Result<DataFolder> open(const std::filesystem::path& folder);
};

// Reads a shard's tables; of motions the columns of single numbers and lists, and those of the
// series that are named and kept.
[[nodiscard]] Result<ShardRows> read_rows(const DataFolder& data, std::uint64_t shard,
                                          const std::vector<DatasetSeries>& series);

// The part of the data set that a motion is of, by its person.
[[nodiscard]] Split split_of(const DataMotion& motion, const DatasetPlan& plan);

// The columns of a motion table, without numbers: those of single numbers and lists, and those of
// the series.
[[nodiscard]] std::vector<std::string> column_names(const Table& table,
                                                    const std::vector<DatasetSeries>& series);

}  // namespace shigusa
