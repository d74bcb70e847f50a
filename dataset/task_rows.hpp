// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/dataset.hpp>
#include <span>
#include <string>
#include <vector>

#include "table.hpp"

namespace shigusa {

// The tables of a data set's tasks, one row a task, and of what belongs to a task.
inline constexpr const char* kTasksTable = "/tasks";
inline constexpr const char* kGoalsTable = "/goals";
inline constexpr const char* kObstaclesTable = "/obstacles";
inline constexpr const char* kMissedTable = "/missed";
// The motions of bodies that are alike: of the same joints, nodes and parameters.
inline constexpr const char* kMotionsGroup = "/motions";

// The word of a task of which no motions can be asked for.
inline constexpr std::string_view kRefused = "refused";

// A task with what came of it, or why nothing can.
struct MadeTask {
  std::uint64_t number = 0;
  Result<DrawnTask> drawn;
  std::vector<Table> tables;  // its rows in each table
  std::uint64_t motions = 0;  // that are kept
  double search_seconds = 0.0;
  double seconds = 0.0;  // in all
};

// Draws a task of a plan, makes its motions and puts all of it into rows.
[[nodiscard]] MadeTask make_task_rows(const DatasetPlan& plan, std::uint64_t number, SimdSet simd);

// The tables of a data set without motions, with no rows.
[[nodiscard]] std::vector<Table> empty_tables();

// Memory (bytes) of the rows of one motion.
[[nodiscard]] std::uint64_t motion_bytes(const TaskFile& file, const Task& task,
                                         std::span<const DatasetSeries> series);

}  // namespace shigusa
