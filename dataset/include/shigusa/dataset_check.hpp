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

/// How far a check has come.
struct CheckReport {
  std::uint64_t shards = 0;    ///< that were looked at
  std::uint64_t of = 0;        ///< that are there
  std::uint64_t replayed = 0;  ///< tasks that were made again
  std::uint64_t problems = 0;  ///< that were found
};

/// How a data set is checked.
struct CheckSettings {
  double share = 0.001;              ///< of the tasks that are made again, 0 to 1; at least one is
  int threads = 0;                   ///< 0: one for each core
  SimdSet simd = widest_simd_set();  ///< of the searches; changes no result
  std::function<void(const CheckReport&)> report{};  ///< called now and then
  const std::atomic<bool>* cancel = nullptr;         ///< ends the work once it is true
};

/// Something that is wrong with a data set.
struct DatasetProblem {
  std::string file;  ///< its name in the folder
  std::string says;  ///< what is wrong with it
};

/// More problems are counted, but not listed.
inline constexpr std::size_t kMostProblems = 1000;

/// The result of a check.
struct CheckRun {
  std::uint64_t shards = 0;                ///< that are there
  std::vector<std::uint64_t> missing{};    ///< numbers of shards that are not there: no problem
  std::uint64_t bytes = 0;                 ///< of the shards
  std::uint64_t replayed = 0;              ///< tasks that were made again
  std::uint64_t motions = 0;               ///< of these tasks
  bool index = false;                      ///< whether there is an index
  std::vector<DatasetProblem> problems{};  ///< by file; the first kMostProblems
  std::uint64_t problem_count = 0;         ///< all of them
  double seconds = 0.0;                    ///< that it took
};

/// Checks a data set: of every shard the bytes by their SHA-256, its plan and its tasks; of a drawn
/// share of the tasks, the same each time, all numbers, by making them again; and whether the
/// index and the statistics, where they are there, are whole and of these shards. One problem does
/// not end it. Fails on a folder without a plan or shards, and where it is cancelled.
[[nodiscard]] Result<CheckRun> check_dataset(const std::filesystem::path& folder,
                                             const CheckSettings& settings = {});

}  // namespace shigusa
