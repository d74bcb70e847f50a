// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// Version of the plans and shards that are read and written.
inline constexpr int kDatasetVersion = 1;
/// Largest size of a plan.
inline constexpr std::size_t kPlanMaxBytes = std::size_t{1} << 20;
/// Largest number of tasks: at a thirtieth of a second each they take a year of one core.
inline constexpr std::uint64_t kDatasetMaxTasks = 1'000'000'000;
/// Largest number of shards: folders with more files are slow on most file systems.
inline constexpr std::uint64_t kDatasetMaxShards = 1'000'000;
/// Largest memory of the series of one shard's motions before compression (bytes).
inline constexpr std::uint64_t kShardMaxBytes = std::uint64_t{32} << 20;
/// Largest number of tasks of a shard if the plan gives none.
inline constexpr std::uint64_t kShardTasks = 1000;

/// A series of numbers stored for each frame of a motion.
enum class DatasetSeries {
  angles,          ///< joint angles
  torques,         ///< joint torques
  nodes,           ///< local rotations of the skeleton's nodes, and the root's position
  positions,       ///< world positions of the skeleton's nodes
  centre_of_mass,  ///< centre of mass in the world
  pressure,        ///< centre of pressure on the floor
  contacts,        ///< support of each foot
  actions,         ///< index of the present action, of tasks with actions
  things,          ///< pose of each thing, of tasks with things
};
/// Words of DatasetSeries.
template <>
inline constexpr std::array kEnumWords<DatasetSeries>{
    EnumWord{DatasetSeries::angles, "angles"},
    EnumWord{DatasetSeries::torques, "torques"},
    EnumWord{DatasetSeries::nodes, "nodes"},
    EnumWord{DatasetSeries::positions, "positions"},
    EnumWord{DatasetSeries::centre_of_mass, "centre_of_mass"},
    EnumWord{DatasetSeries::pressure, "pressure"},
    EnumWord{DatasetSeries::contacts, "contacts"},
    EnumWord{DatasetSeries::actions, "actions"},
    EnumWord{DatasetSeries::things, "things"},
};

/// Selection of motions that a data set keeps.
enum class KeptMotions {
  possible,  ///< reach their goals and are possible for the body
  reached,   ///< reach their goals
  all,       ///< all, including those that end nearest to goals out of reach
};
/// Words of KeptMotions.
template <>
inline constexpr std::array kEnumWords<KeptMotions>{
    EnumWord{KeptMotions::possible, "possible"},
    EnumWord{KeptMotions::reached, "reached"},
    EnumWord{KeptMotions::all, "all"},
};

/// Range of a shard's tasks, [first, last).
struct TaskRange {
  std::uint64_t first = 0;  ///< first task number
  std::uint64_t last = 0;   ///< one past the last task number
};

/// A task drawn from a plan.
struct DrawnTask {
  TaskFile file;             ///< the task with a measured character
  std::uint64_t person = 0;  ///< number of the person
};

/// A plan of many tasks: a task file in which any value may be a draw, such as {"uniform": [0,
/// 15]}, and the number of tasks to draw. docs/data.md describes the draws. Each draw depends only
/// on (seed, task, place of the value), so that adding a draw changes no other.
class DatasetPlan {
 public:
  /// Parses a plan and validates it: its draws at both ends of their ranges and with each of their
  /// choices must give tasks, its characters must be measurable, and a shard is at most
  /// kShardMaxBytes. Characters are read relative to `folder`. Errors state the place ("plan.json:
  /// task.goals[0].load_kg"), the value seen and the allowed range.
  [[nodiscard]] static Result<DatasetPlan> parse(std::string_view text, std::string_view name,
                                                 const std::filesystem::path& folder);
  /// Reads and parses a plan's file; its characters are read relative to the file's folder.
  [[nodiscard]] static Result<DatasetPlan> read(const std::filesystem::path& path);

  [[nodiscard]] const std::string& name() const;     ///< title for the data card
  [[nodiscard]] const std::string& licence() const;  ///< licence for the data card
  [[nodiscard]] std::uint64_t seed() const;          ///< seed of all draws
  [[nodiscard]] std::uint64_t tasks() const;         ///< number of tasks
  [[nodiscard]] std::uint64_t people() const;        ///< people shared by the tasks; 0: one per
                                                     ///< task
  [[nodiscard]] std::uint64_t shard_tasks() const;   ///< tasks of a shard, except the last one
  [[nodiscard]] std::uint64_t shards() const;        ///< number of shards
  [[nodiscard]] TaskRange tasks_of(std::uint64_t shard) const;     ///< tasks of one shard
  [[nodiscard]] const std::vector<DatasetSeries>& series() const;  ///< stored series
  [[nodiscard]] KeptMotions motions() const;                       ///< stored motions
  /// The plan as JSON text in a canonical form, which shards store.
  [[nodiscard]] const std::string& text() const;
  /// SHA-256 of text() and of the characters' files, 64 hexadecimal digits: equal for all shards of
  /// a data set.
  [[nodiscard]] const std::string& digest() const;

  /// The plan as a file for a folder, with paths of characters relative to it.
  [[nodiscard]] std::string text_in(const std::filesystem::path& folder) const;
  /// Files of the characters as named in the plan, sorted.
  [[nodiscard]] const std::vector<std::string>& character_files() const;

  /// Draws task 0..tasks()-1. Fails if the draws give no valid task: a mass out of range, no
  /// reachable place.
  [[nodiscard]] Result<DrawnTask> task(std::uint64_t index) const;

 private:
  struct Made;
  explicit DatasetPlan(std::shared_ptr<const Made> made) : made_(std::move(made)) {}
  // shared by copies of a plan, as it never changes
  std::shared_ptr<const Made> made_;
};

/// JSON schema of plans, the contents of docs/plan.schema.json.
[[nodiscard]] std::string plan_schema();

/// Progress of making a data set.
struct DatasetReport {
  std::uint64_t tasks = 0;    ///< tasks made in this run
  std::uint64_t motions = 0;  ///< motions of these tasks
  std::uint64_t of = 0;       ///< tasks to be made in this run
  double seconds = 0.0;       ///< elapsed time of the run
};

/// Settings of making a data set; only `shards` changes the output.
struct DatasetSettings {
  std::filesystem::path folder;                        ///< destination of the shards
  std::uint64_t first_shard = 0;                       ///< first shard to make
  std::optional<std::uint64_t> last_shard{};           ///< one past the last shard; none: all
  int threads = 0;                                     ///< 0: one per core
  SimdSet simd = widest_simd_set();                    ///< SIMD set of the searches
  std::function<void(const DatasetReport&)> report{};  ///< called regularly
  /// if it becomes true, work ends after the current shard
  const std::atomic<bool>* cancel = nullptr;
};

/// Counts and times of a run.
struct DatasetRun {
  std::uint64_t made = 0;       ///< shards made
  std::uint64_t there = 0;      ///< shards that existed before
  std::uint64_t left = 0;       ///< shards left when the work was cancelled
  std::uint64_t tasks = 0;      ///< tasks of the shards made
  std::uint64_t motions = 0;    ///< motions of the shards made
  double seconds = 0.0;         ///< elapsed time
  double search_seconds = 0.0;  ///< time of searches, summed over threads
  double thread_seconds = 0.0;  ///< time of making tasks, summed over threads
};

/// File name of a shard, "shard-000012.h5".
[[nodiscard]] std::string shard_name(std::uint64_t shard);
/// Name of a data set's plan in its folder.
inline constexpr const char* kPlanName = "plan.json";
/// Stores the plan in a data set's folder, as kPlanName, so that the data set can be made again and
/// examined from the folder alone. Fails if the folder has another plan.
[[nodiscard]] Result<void> keep_plan(const DatasetPlan& plan, const std::filesystem::path& folder);

/// Makes the missing shards of a plan, one after the other, each whole or not at all; docs/data.md
/// describes their contents. The same plan gives the same bytes for any number of threads, SIMD set
/// and order. Fails if a shard cannot be written, and on a folder with another plan.
[[nodiscard]] Result<DatasetRun> make_dataset(const DatasetPlan& plan,
                                              const DatasetSettings& settings);

}  // namespace shigusa
