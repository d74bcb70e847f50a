// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/json_text.hpp"
#include "shard_file.hpp"
#include "splits.hpp"
#include "table.hpp"

namespace shigusa {

// Running mean and variance. Blocks of numbers are added one after the other; their order and sizes
// determine the last bits.
struct Moments {
  std::uint64_t count = 0;
  double mean = 0.0;
  double squares = 0.0;  // sum of (number - mean)²
  double least = kNoNumber;
  double most = kNoNumber;

  void add(const Moments& block);
  [[nodiscard]] double deviation() const;  // standard deviation, of all there are
};

// Moments of `columns` numbers per row; NaN and infinities are left out.
void add_moments(std::span<const double> rows, std::vector<Moments>& columns);

// Approximate quantiles from counts: numbers with the same sign, exponent and first 12 bits of the
// fraction share a count. The relative error is at most 1/4000.
class Quantiles {
 public:
  void add(double value);  // NaN is left out
  // Quantile at `share` (0 to 1); NaN if there are no numbers.
  [[nodiscard]] double at(double share) const;

 private:
  std::uint64_t total_ = 0;
  std::map<std::uint64_t, std::uint64_t> counts_;  // by the numbers' first bits, in their order
  double least_ = kNoNumber;
  double most_ = kNoNumber;
};
// Shares for which quantiles are reported.
inline constexpr std::array kQuantileShares{0.0, 0.05, 0.25, 0.5, 0.75, 0.95, 1.0};

// Counts per word.
using Counts = std::map<std::string, std::uint64_t>;

// A series with one number per joint and frame.
struct JointStatistics {
  std::string series;  // "angles"
  std::string unit;
  std::vector<Moments> joints;
};

// Statistics of the motions of similar bodies.
struct MotionStatistics {
  std::uint64_t motions = 0;
  std::vector<std::string> joints;
  std::vector<JointStatistics> series;
  Quantiles scores;
  Counts verdicts;
  Counts postures;
};

// Counts of a split.
struct SplitCounts {
  std::uint64_t tasks = 0;
  std::uint64_t motions = 0;
};
using SplitShares = std::array<SplitCounts, kEnumWords<Split>.size()>;

// Statistics of a data set. Shards are added in order; memory does not grow with them.
struct DatasetStatistics {
  std::uint64_t tasks = 0;
  std::uint64_t motions = 0;
  std::uint64_t refused = 0;  // tasks without possible motions
  std::uint64_t missed = 0;   // tasks whose goals are not met
  std::uint64_t evaluations = 0;
  // of tasks
  Counts statuses;
  Counts characters;
  Counts presets;
  Counts sexes;
  Counts effectors;  // of goals
  Moments stature_m;
  Moments mass_kg;
  Moments load_kg;  // of goals with a load
  std::array<Moments, 3> goal_m;
  SplitShares by_person{};
  SplitShares by_region{};
  std::map<std::string, MotionStatistics> tables;  // by their path

  // Adds a shard's motions of one table. Fails if it cannot be read.
  [[nodiscard]] Result<void> add_motions(const ShardReader& shard, const std::string& path);
  // Adds a shard's rows of the named tables, which have the columns of kTaskColumns, …
  void add_tasks(const Table& tasks, const Table& splits);
  void add_goals(const Table& goals);
  void add_missed(const Table& missed);
};
inline constexpr std::array kTaskColumns{"task",   "person",     "status",    "motions",
                                         "sex",    "character",  "stature_m", "mass_kg",
                                         "preset", "evaluations"};
inline constexpr std::array kGoalColumns{"task", "effector", "position_m", "load_kg"};
inline constexpr std::array kMissedColumns{"task"};

// Statistics as tables of an HDF5 file, below /statistics.
[[nodiscard]] std::vector<Table> tables_of(const DatasetStatistics& statistics);
// The same as a JSON object.
[[nodiscard]] Json json_of(const DatasetStatistics& statistics);

}  // namespace shigusa
