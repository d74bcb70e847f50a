// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/dataset.hpp>
#include <string>

#include "shard_file.hpp"
#include "shard_list.hpp"
#include "statistics.hpp"

namespace shigusa {

// Adds a shard to the statistics of its data set, and its tasks' rows to a table of splits.
[[nodiscard]] Result<void> add_shard_numbers(const ShardReader& shard, const DatasetPlan& plan,
                                             DatasetStatistics& statistics, Table& splits);

// Text of a data set's statistics file.
[[nodiscard]] std::string format_statistics(const DatasetPlan& plan, const ShardList& shards,
                                            const DatasetStatistics& statistics);

}  // namespace shigusa
