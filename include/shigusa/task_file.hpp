// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <shigusa/character.hpp>
#include <shigusa/result.hpp>
#include <shigusa/task.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The version of the format that is written.
inline constexpr int kTaskVersion = 1;
/// A larger file is refused.
inline constexpr std::size_t kTaskMaxBytes = std::size_t{1} << 20;

/// A task as its JSON file holds it; docs/task.schema.json is its schema.
struct TaskFile : Request {
  CharacterSpec character{};  ///< the one who moves
};

/// Parses what stands under "character" in a task: an object, or a source alone as a JSON text.
[[nodiscard]] Result<CharacterSpec> parse_character_spec(std::string_view text,
                                                         std::string_view name);

/// Parses a task. Errors name the place ("task.json: goals[0].position_m"), the value seen and what
/// is allowed; a misspelt key gets the nearest one suggested.
[[nodiscard]] Result<TaskFile> parse_task(std::string_view text, std::string_view name);
/// Reads and parses a task's file.
[[nodiscard]] Result<TaskFile> read_task(const std::filesystem::path& path);

/// The task as JSON text: parse_task of it gives the same task, bit for bit (names that are not
/// UTF-8 and what a built-in body does not use excepted).
[[nodiscard]] std::string format_task(const TaskFile& task);

/// The JSON schema of task files, as docs/task.schema.json has it.
[[nodiscard]] std::string task_schema();

/// The task's body, standing on a foot that no goal moves where its character has two to stand on.
/// The character must have been measured; fails as build_character.
[[nodiscard]] Result<BodyModel> build_body(const TaskFile& file);

/// Measures the character where needed (see measure_character) and makes the task to be generated.
[[nodiscard]] Result<Task> make_task(TaskFile& file, const std::filesystem::path& folder);

}  // namespace shigusa
