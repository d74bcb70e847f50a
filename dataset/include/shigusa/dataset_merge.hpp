// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <shigusa/dataset.hpp>
#include <shigusa/error.hpp>
#include <string>
#include <vector>

namespace shigusa {

/// The name of a data set's index in its folder.
inline constexpr const char* kIndexName = "index.h5";
/// The name of its statistics as JSON.
inline constexpr const char* kStatisticsName = "statistics.json";
/// The name of its data card.
inline constexpr const char* kCardName = "README.md";
/// The index of more shards has no virtual datasets. For each column each shard costs 16 kB of
/// memory, 25 µs and 70 bytes of the file when it is written (1000 shards and 60 columns: 2 s and 4
/// MB); and a reader of a whole column has all shards open at once, at 0.5 MB each.
inline constexpr std::uint64_t kMostMappedShards = 5000;

/// How far a merge has come.
struct MergeReport {
  std::uint64_t shards = 0;  ///< that were read
  std::uint64_t of = 0;      ///< that are there
};

/// How an index is made.
struct MergeSettings {
  std::string program = "shigusa";  ///< as the data card names it, with its version
  std::function<void(const MergeReport&)> report{};  ///< called after each shard
  const std::atomic<bool>* cancel = nullptr;         ///< ends the work once it is true
};

/// The counts of an index.
struct MergeRun {
  std::uint64_t shards = 0;              ///< that it is of
  std::vector<std::uint64_t> missing{};  ///< numbers of the shards that are not there
  std::uint64_t tasks = 0;               ///< of the shards that are there
  std::uint64_t motions = 0;             ///< the same
  std::uint64_t bytes = 0;               ///< of the index
  bool mapped = true;                    ///< false: there are more than kMostMappedShards
  double seconds = 0.0;                  ///< that it took
};

/// Writes what makes one of a data set's shards: kIndexName, an HDF5 file in which every table of
/// the shards is one table (virtual datasets, so that no number is there twice), with /shards,
/// /splits and /statistics; kStatisticsName; and kCardName. Shards that are not made yet are left
/// out. Same shards, same bytes; each file is whole or as it was. Fails on a folder without a plan
/// or shards, and on a shard that is damaged or another plan's, which it names.
[[nodiscard]] Result<MergeRun> merge_dataset(const std::filesystem::path& folder,
                                             const MergeSettings& settings = {});

/// Writes the first data card of a folder, which tells what its plan will make; merge_dataset
/// writes it again with the counts. Leaves a card that is there as it is.
[[nodiscard]] Result<void> write_first_card(const DatasetPlan& plan,
                                            const std::filesystem::path& folder,
                                            const std::string& program = "shigusa");

}  // namespace shigusa
