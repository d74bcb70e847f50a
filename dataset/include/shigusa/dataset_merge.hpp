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

/// Name of a data set's index in its folder.
inline constexpr const char* kIndexName = "index.h5";
/// Name of its statistics as JSON.
inline constexpr const char* kStatisticsName = "statistics.json";
/// Name of its data card.
inline constexpr const char* kCardName = "README.md";
/// Largest number of shards for which the index has virtual datasets. Per column and shard, writing
/// takes 16 kB of memory, 25 µs and 70 bytes of the file (1000 shards and 60 columns: 2 s and 4
/// MB); a reader of a whole column has all shards open at once, at 0.5 MB each.
inline constexpr std::uint64_t kMostMappedShards = 5000;

/// Progress of a merge.
struct MergeReport {
  std::uint64_t shards = 0;  ///< shards read
  std::uint64_t of = 0;      ///< existing shards
};

/// Settings of an index.
struct MergeSettings {
  std::string program = "shigusa";  ///< name of the program with its version, for the data card
  std::function<void(const MergeReport&)> report{};  ///< called after each shard
  const std::atomic<bool>* cancel = nullptr;         ///< ends the work once true
};

/// Counts of an index.
struct MergeRun {
  std::uint64_t shards = 0;              ///< shards in the index
  std::vector<std::uint64_t> missing{};  ///< numbers of missing shards
  std::uint64_t tasks = 0;               ///< tasks of existing shards
  std::uint64_t motions = 0;             ///< motions of existing shards
  std::uint64_t bytes = 0;               ///< size of the index
  bool mapped = true;                    ///< false if there are more than kMostMappedShards
  double seconds = 0.0;                  ///< elapsed time
};

/// Joins the shards of a data set: writes kIndexName, an HDF5 file in which every table of the
/// shards is one table (virtual datasets, without copies of numbers), with /shards, /splits and
/// /statistics; kStatisticsName; and kCardName. Missing shards are left out. The same shards give
/// the same bytes; each file is replaced whole or not at all. Fails on a folder without a plan or
/// shards, and on a shard, named in the error, that is damaged or of another plan.
[[nodiscard]] Result<MergeRun> merge_dataset(const std::filesystem::path& folder,
                                             const MergeSettings& settings = {});

/// Writes the first data card of a folder, which describes the plan; merge_dataset rewrites it with
/// counts. An existing card is kept.
[[nodiscard]] Result<void> write_first_card(const DatasetPlan& plan,
                                            const std::filesystem::path& folder,
                                            const std::string& program = "shigusa");

}  // namespace shigusa
