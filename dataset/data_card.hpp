// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <shigusa/dataset.hpp>
#include <string>
#include <vector>

#include "statistics.hpp"
#include "table.hpp"

namespace shigusa {

// Contents of a data card. Borrows all members.
struct CardFacts {
  const DatasetPlan& plan;
  std::string program;  // "shigusa 0.1.0"
  // tables of motions without rows; before there are shards see planned_tables
  const std::vector<Table>& motions;
  const DatasetStatistics* statistics = nullptr;  // none before there are shards
  std::uint64_t missing = 0;                      // shards
  bool mapped = true;                             // the index has virtual datasets
  std::uint64_t first_shard = 0;                  // that is there
};

// The data card as Markdown.
[[nodiscard]] std::string format_card(const CardFacts& facts);

// Table of motions, without rows, of the first task of a plan that has a body; empty if none of the
// first few has one.
[[nodiscard]] std::vector<Table> planned_tables(const DatasetPlan& plan);

}  // namespace shigusa
