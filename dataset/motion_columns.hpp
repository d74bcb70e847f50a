// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/dataset.hpp>
#include <span>

#include "table.hpp"

namespace shigusa {

// Frames of a motion.
inline constexpr std::size_t kDataFrames = kMotionSteps + 1;

// Lists of names of a motion table.
inline constexpr const char* kMotionLists[] = {"joints", "parameters",   "criteria",
                                               "nodes",  "node_parents", "feet"};

// Adds the columns of a motion table without rows; the table's lists give their sizes.
void add_motion_columns(std::span<const DatasetSeries> series, Table& table);

}  // namespace shigusa
