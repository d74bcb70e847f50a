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

/// The version of the plans and shards that are read and written.
inline constexpr int kDatasetVersion = 1;
/// A larger plan is refused.
inline constexpr std::size_t kPlanMaxBytes = std::size_t{1} << 20;
/// More tasks are refused: at a thirtieth of a second each they take a year of one core.
inline constexpr std::uint64_t kDatasetMaxTasks = 1'000'000'000;
/// More shards are refused: a folder of more files is slow on most file systems.
inline constexpr std::uint64_t kDatasetMaxShards = 1'000'000;
/// The series of one shard's motions take at most this much memory before they are packed (bytes).
inline constexpr std::uint64_t kShardMaxBytes = std::uint64_t{32} << 20;
/// The most tasks of a shard, where a plan says nothing.
inline constexpr std::uint64_t kShardTasks = 1000;

/// A series of numbers that is kept of each frame of a motion.
enum class DatasetSeries {
  angles,     ///< of the joints
  torques,    ///< of the joints
  nodes,      ///< of the skeleton's nodes, how each is turned in its parent, and the root's place
  positions,  ///< of the skeleton's nodes, in the world
  centre_of_mass,  ///< in the world
  pressure,        ///< centre of pressure on the floor
  contacts,        ///< what each foot stands on
};
/// The words of DatasetSeries.
template <>
inline constexpr std::array kEnumWords<DatasetSeries>{
    EnumWord{DatasetSeries::angles, "angles"},
    EnumWord{DatasetSeries::torques, "torques"},
    EnumWord{DatasetSeries::nodes, "nodes"},
    EnumWord{DatasetSeries::positions, "positions"},
    EnumWord{DatasetSeries::centre_of_mass, "centre_of_mass"},
    EnumWord{DatasetSeries::pressure, "pressure"},
    EnumWord{DatasetSeries::contacts, "contacts"},
};

/// The motions that a data set keeps.
enum class KeptMotions {
  possible,  ///< those that meet their goals and that the body could make
  reached,   ///< all that meet their goals
  all,       ///< also those that end nearest to goals out of reach
};
/// The words of KeptMotions.
template <>
inline constexpr std::array kEnumWords<KeptMotions>{
    EnumWord{KeptMotions::possible, "possible"},
    EnumWord{KeptMotions::reached, "reached"},
    EnumWord{KeptMotions::all, "all"},
};

/// The tasks of a shard: first to last, the last one not among them.
struct TaskRange {
  std::uint64_t first = 0;  ///< number of a task
  std::uint64_t last = 0;   ///< number of the task after the last
};

/// A task that was drawn of a plan.
struct DrawnTask {
  TaskFile file;             ///< as a file of it would say; the character is measured
  std::uint64_t person = 0;  ///< number of the person
};

/// A plan of many tasks: a task as its file has it, in which any value may be a draw, such as
/// {"uniform": [0, 15]}, and how many to draw of it. docs/data.md tells the draws. Each draw comes
/// from (seed, task, place of the value) alone, so that one more draw changes no other.
class DatasetPlan {
 public:
  /// Parses a plan and checks it before any work: its draws at both ends of their ranges and with
  /// each of their choices give tasks, its characters can be measured, and a shard is no larger
  /// than kShardMaxBytes. Characters are looked for in `folder`. Errors name the place ("plan.json:
  /// task.goals[0].load_kg"), the value seen and what is allowed.
  [[nodiscard]] static Result<DatasetPlan> parse(std::string_view text, std::string_view name,
                                                 const std::filesystem::path& folder);
  /// Reads and parses a plan's file; its characters are looked for beside it.
  [[nodiscard]] static Result<DatasetPlan> read(const std::filesystem::path& path);

  [[nodiscard]] const std::string& name() const;     ///< for the data card
  [[nodiscard]] const std::string& licence() const;  ///< for the data card
  [[nodiscard]] std::uint64_t seed() const;          ///< of all draws
  [[nodiscard]] std::uint64_t tasks() const;         ///< number of tasks
  [[nodiscard]] std::uint64_t people() const;        ///< of which tasks draw one; 0: each its own
  [[nodiscard]] std::uint64_t shard_tasks() const;   ///< tasks of a shard, but for the last
  [[nodiscard]] std::uint64_t shards() const;        ///< number of shards
  [[nodiscard]] TaskRange tasks_of(std::uint64_t shard) const;     ///< of one shard
  [[nodiscard]] const std::vector<DatasetSeries>& series() const;  ///< that are kept
  [[nodiscard]] KeptMotions motions() const;                       ///< that are kept
  /// The plan as JSON text in one form, whatever its file looked like: what a shard says it is of.
  [[nodiscard]] const std::string& text() const;
  /// The SHA-256 of text() and of the characters' files, 64 hexadecimal digits: what shards that
  /// belong together have in common.
  [[nodiscard]] const std::string& digest() const;

  /// The plan as a file of a folder, which finds its characters from there.
  [[nodiscard]] std::string text_in(const std::filesystem::path& folder) const;
  /// The characters' files, as the plan names them, sorted.
  [[nodiscard]] const std::vector<std::string>& character_files() const;

  /// Draws one task, 0..tasks()-1. Fails where no task can come of its draws: a mass out of range,
  /// no place in reach.
  [[nodiscard]] Result<DrawnTask> task(std::uint64_t index) const;

 private:
  struct Made;
  explicit DatasetPlan(std::shared_ptr<const Made> made) : made_(std::move(made)) {}
  // copies of a plan share it, as it never changes
  std::shared_ptr<const Made> made_;
};

/// The JSON schema of plans, as docs/plan.schema.json has it.
[[nodiscard]] std::string plan_schema();

/// How far a data set has come.
struct DatasetReport {
  std::uint64_t tasks = 0;    ///< that were made in this run
  std::uint64_t motions = 0;  ///< of these
  std::uint64_t of = 0;       ///< tasks that this run has to make
  double seconds = 0.0;       ///< since its beginning
};

/// How a data set is made; only `shards` changes what is written.
struct DatasetSettings {
  std::filesystem::path folder;                        ///< that gets the shards
  std::uint64_t first_shard = 0;                       ///< first one to be made
  std::optional<std::uint64_t> last_shard{};           ///< the one after the last; none: all
  int threads = 0;                                     ///< 0: one for each core
  SimdSet simd = widest_simd_set();                    ///< of the searches
  std::function<void(const DatasetReport&)> report{};  ///< called now and then
  /// ends the work after the shard that is being made, once it is true
  const std::atomic<bool>* cancel = nullptr;
};

/// The counts and times of a run.
struct DatasetRun {
  std::uint64_t made = 0;       ///< shards that were made
  std::uint64_t there = 0;      ///< shards that were there before
  std::uint64_t left = 0;       ///< shards that are not made, as the work was cancelled
  std::uint64_t tasks = 0;      ///< of the shards that were made
  std::uint64_t motions = 0;    ///< the same
  double seconds = 0.0;         ///< that all of it took
  double search_seconds = 0.0;  ///< of all threads together, that searches took
  double thread_seconds = 0.0;  ///< of all threads together, that making tasks took
};

/// "shard-000012.h5".
[[nodiscard]] std::string shard_name(std::uint64_t shard);
/// The name of a data set's plan in its folder.
inline constexpr const char* kPlanName = "plan.json";
/// Keeps the plan in a data set's folder, as kPlanName, so that what is there can be made again and
/// looked at by the folder alone. Fails where the folder has another plan.
[[nodiscard]] Result<void> keep_plan(const DatasetPlan& plan, const std::filesystem::path& folder);

/// Makes the shards of a plan that are not there yet, one after the other, each whole or not at
/// all: docs/data.md tells what is in them. Same plan, same bytes, whatever the threads, the SIMD
/// set and the order. Fails where a shard cannot be written, and on a folder that holds another
/// plan's.
[[nodiscard]] Result<DatasetRun> make_dataset(const DatasetPlan& plan,
                                              const DatasetSettings& settings);

}  // namespace shigusa
