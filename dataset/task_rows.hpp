// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/dataset.hpp>
#include <span>
#include <string>
#include <vector>

#include "table.hpp"

namespace shigusa {

// Tables of a data set's tasks and their parts, one row per task.
inline constexpr const char* kTasksTable = "/tasks";
inline constexpr const char* kGoalsTable = "/goals";
inline constexpr const char* kObstaclesTable = "/obstacles";
inline constexpr const char* kMissedTable = "/missed";
// Motions of similar bodies: with the same joints, nodes and parameters.
inline constexpr const char* kMotionsGroup = "/motions";

// Status of a task for which no motions can be requested.
inline constexpr std::string_view kRefused = "refused";

// A task with its result, or the reason why it has none.
struct MadeTask {
  std::uint64_t number = 0;
  Result<DrawnTask> drawn;
  std::vector<Table> tables;  // its rows in each table
  std::uint64_t motions = 0;  // that are kept
  double search_seconds = 0.0;
  double seconds = 0.0;  // in all
};

// Draws a task of a plan, makes its motions and converts them to rows.
[[nodiscard]] MadeTask make_task_rows(const DatasetPlan& plan, std::uint64_t number, SimdSet simd);

// Tables of a data set except those of motions, without rows.
[[nodiscard]] std::vector<Table> empty_tables();

// Memory (bytes) of the rows of one motion.
[[nodiscard]] std::uint64_t motion_bytes(const TaskFile& file, const Task& task,
                                         std::span<const DatasetSeries> series);

}  // namespace shigusa
