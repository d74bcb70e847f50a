// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/dataset.hpp>
#include <span>
#include <string>
#include <vector>

#include "table.hpp"

namespace shigusa {

// A body's degree of freedom in data sets: in the same order for either standing foot; for robots
// the file's joint in the file's direction.
struct DataDof {
  std::string name;
  int dof = 0;        // of the body
  double sign = 1.0;  // the column has sign · q
};

// Writer of the rows of one task's motions.
class MotionTable {
 public:
  // Borrows all arguments.
  MotionTable(const TaskFile& file, const Task& task, std::span<const DatasetSeries> series);

  void add(std::uint64_t number, std::size_t rank, const GenerateResult& generation);
  [[nodiscard]] Table take() { return std::move(table_); }
  // Memory (bytes) of one motion.
  [[nodiscard]] std::uint64_t row_size() const;

 private:
  void describe();
  [[nodiscard]] Column& into(DatasetSeries series) { return table_[word_of(series)]; }
  // `own`: the candidate in its own frames, of which others are too coarse for differences.
  void add_series(DatasetSeries series, const Candidate& candidate, const Candidate& own);
  void add_nodes(const Candidate& candidate, bool turns);
  void add_pressure(const Candidate& own);
  void add_contacts(const Candidate& candidate);
  void add_parameters(const Candidate& candidate);

  const TaskFile& file_;
  const Task& task_;
  std::span<const DatasetSeries> series_;
  std::vector<DataDof> dofs_;
  ParameterList list_;
  std::vector<std::string> parameters_;  // sorted names
  std::vector<std::size_t> order_;       // their indices in the list
  std::vector<std::string> feet_;        // names, sorted
  Table table_;
};

}  // namespace shigusa
