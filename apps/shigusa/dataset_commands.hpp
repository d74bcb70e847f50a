// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace shigusa::app {

// Heading of these commands in `shigusa dataset --help`.
inline constexpr const char* kOfDataset = "Commands of a data set that is there";

// The further commands for data sets; each function adds one to `shigusa dataset`.
void add_dataset_merge(CLI::App& dataset, int& exit_code);
void add_dataset_check(CLI::App& dataset, int& exit_code);
void add_dataset_export(CLI::App& dataset, int& exit_code);

// List of shards, "12 shards: 3, 7 to 17".
[[nodiscard]] std::string missing_shards_text(const std::vector<std::uint64_t>& missing);

}  // namespace shigusa::app
