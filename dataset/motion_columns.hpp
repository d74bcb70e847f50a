// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/dataset.hpp>
#include <span>

#include "table.hpp"

namespace shigusa {

// Frames of a motion.
inline constexpr std::size_t kDataFrames = kMotionSteps + 1;

// The lists of names that a table of motions has.
inline constexpr const char* kMotionLists[] = {"joints", "parameters",   "criteria",
                                               "nodes",  "node_parents", "feet"};

// Adds the columns of a table of motions, without rows: what these are of stands in the table's
// lists.
void add_motion_columns(std::span<const DatasetSeries> series, Table& table);

}  // namespace shigusa
