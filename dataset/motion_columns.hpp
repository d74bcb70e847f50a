// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/dataset.hpp>
#include <span>

#include "table.hpp"

namespace shigusa {

// Frames of a motion, and of a piece of work.
inline constexpr std::size_t kDataFrames = kMotionSteps + 1;
inline constexpr std::size_t kWorkFrames = 4 * kMotionSteps + 1;

// Lists of names of a motion table.
inline constexpr const char* kMotionLists[] = {"joints", "parameters",   "criteria",
                                               "nodes",  "node_parents", "feet"};

// Lists of names that a table of pieces of work has beside them; none of things without any.
inline constexpr const char* kWorkLists[] = {"actions", "things"};
// Numbers of a thing's pose: x, y, z, and x, y, z, w of its rotation.
inline constexpr std::size_t kPoseNumbers = 7;

// Whether a motion table is of pieces of work.
[[nodiscard]] bool is_of_work(const Table& table);
// Frames of the motions of a table.
[[nodiscard]] std::size_t frames_of(const Table& table);

// Adds the columns of a motion table without rows; the table's lists give their sizes.
void add_motion_columns(std::span<const DatasetSeries> series, Table& table);

}  // namespace shigusa
