// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/dataset.hpp>
#include <string>
#include <vector>

#include "statistics.hpp"
#include "table.hpp"

namespace shigusa {

// The facts that a data card tells. Borrows all of it.
struct CardFacts {
  const DatasetPlan& plan;
  std::string program;  // "shigusa 0.1.0"
  // the motions' tables without rows; where there are no shards yet, see planned_tables
  const std::vector<Table>& motions;
  const DatasetStatistics* statistics = nullptr;  // none before there are shards
  std::uint64_t missing = 0;                      // shards
  bool mapped = true;                             // the index has virtual datasets
  std::uint64_t first_shard = 0;                  // that is there
};

// The data card: Markdown in plain English.
[[nodiscard]] std::string format_card(const CardFacts& facts);

// The table, without rows, of the motions of the first task of a plan that has a body; none where
// none of the first few has.
[[nodiscard]] std::vector<Table> planned_tables(const DatasetPlan& plan);

}  // namespace shigusa
