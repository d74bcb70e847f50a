// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <shigusa/error.hpp>
#include <shigusa/run.hpp>
#include <string>
#include <vector>

namespace shigusa {

/// Progress of a check.
struct CheckReport {
  std::uint64_t shards = 0;    ///< shards examined
  std::uint64_t of = 0;        ///< existing shards
  std::uint64_t replayed = 0;  ///< tasks made again
  std::uint64_t problems = 0;  ///< problems found
};

/// Settings of a check.
struct CheckSettings {
  double share = 0.001;              ///< share of the tasks to make again, 0 to 1; at least one is
  int threads = 0;                   ///< 0: one per core
  SimdSet simd = widest_simd_set();  ///< SIMD set of the searches; does not change results
  std::function<void(const CheckReport&)> report{};  ///< called regularly
  const std::atomic<bool>* cancel = nullptr;         ///< ends the work once true
};

/// A problem of a data set.
struct DatasetProblem {
  std::string file;  ///< file name in the folder
  std::string says;  ///< description of the problem
};

/// Number of problems listed; further ones are only counted.
inline constexpr std::size_t kMostProblems = 1000;

/// Result of a check.
struct CheckRun {
  std::uint64_t shards = 0;                ///< existing shards
  std::vector<std::uint64_t> missing{};    ///< numbers of missing shards, which are no problem
  std::uint64_t bytes = 0;                 ///< total size of the shards
  std::uint64_t replayed = 0;              ///< tasks made again
  std::uint64_t motions = 0;               ///< of these tasks
  bool index = false;                      ///< whether there is an index
  std::vector<DatasetProblem> problems{};  ///< by file; the first kMostProblems
  std::uint64_t problem_count = 0;         ///< number of all problems
  double seconds = 0.0;                    ///< elapsed time
};

/// Checks a data set: SHA-256, plan and tasks of every shard; all numbers of a sample of the tasks,
/// always the same, by making them again; and index and statistics, if present, for completeness
/// and agreement with the shards. A problem does not end the check. Fails on a folder without a
/// plan or shards, and if cancelled.
[[nodiscard]] Result<CheckRun> check_dataset(const std::filesystem::path& folder,
                                             const CheckSettings& settings = {});

}  // namespace shigusa
