// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <shigusa/character/character.hpp>
#include <shigusa/core/result.hpp>
#include <shigusa/task/task.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// The version of the format that is written.
inline constexpr int kTaskVersion = 1;
// A larger file is refused.
inline constexpr std::size_t kTaskMaxBytes = std::size_t{1} << 20;

// A task as its JSON file holds it; docs/task.schema.json is its schema. Criteria and candidates
// are the preset's own where a file does not say.
struct TaskFile {
  CharacterSpec character;            // who moves
  std::vector<Goal> goals;            // see Task
  std::vector<Obstacle> obstacles{};  // see Task
  std::optional<double> duration;     // s
  Preset preset = Preset::flat;       // how the parameters are searched
  LayerReading layer_reading = LayerReading::shared_contractions;  // of layered presets
  std::optional<SearchMethod> search;  // the preset's own when not given
  // the built-in ones: functions do not go into files
  CriteriaSettings criteria = traits_of(Preset::flat).criteria();
  std::vector<std::string> fixed;  // parameters that are not searched, as assignments
  bool pareto = false;             // see Task
  MotionGenerator generator = MotionGenerator::weighted_ik;  // see Task
  int phases = 1;                                            // 1..kPhasesMax
  std::uint64_t seed = 0;                                    // the same seed gives the same motions
  int candidates = traits_of(Preset::flat).candidates;       // 1..1000
  std::optional<int> evaluations;  // motions the search may score, 8..1e9; see Task
  std::optional<Vec3d> look_at{};  // m, world; see Task
  std::optional<std::vector<std::string>> contacts{};  // see Task
};

// Parses what stands under "character" in a task: an object, or a source alone as a JSON text.
[[nodiscard]] Result<CharacterSpec> parse_character_spec(std::string_view text,
                                                         std::string_view name);

// Parses a task. Errors name the place ("task.json: goals[0].position_m"), the value seen and what
// is allowed; a misspelt key gets the nearest one suggested.
[[nodiscard]] Result<TaskFile> parse_task(std::string_view text, std::string_view name);
// Reads and parses a task's file.
[[nodiscard]] Result<TaskFile> read_task(const std::filesystem::path& path);

// The task as JSON text: parse_task of it gives the same task, bit for bit (names that are not
// UTF-8 and what a built-in body does not use excepted).
[[nodiscard]] std::string format_task(const TaskFile& task);

// The task's body, standing on a foot that no goal moves where its character has two to stand on.
// The character must have been measured; fails as build_character.
[[nodiscard]] Result<BodyModel> build_body(const TaskFile& file);

// Measures the character where needed (see measure_character) and makes the task to be generated.
[[nodiscard]] Result<Task> make_task(TaskFile& file, const std::filesystem::path& folder);

}  // namespace shigusa
