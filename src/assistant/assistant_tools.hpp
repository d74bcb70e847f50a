// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <filesystem>
#include <shigusa/files.hpp>
#include <shigusa/run.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "formats/json_text.hpp"

namespace shigusa {

// Results that are kept for edits; the oldest is forgotten for another.
inline constexpr std::size_t kAssistantResultsMost = 16;

struct AssistantSettings {
  std::filesystem::path folder{};  // below which files may be read; empty: none are
  PictureMaker from_svg{};         // for PNG
  double seconds = 300.0;          // longest search, and the usual one
  int threads = 0;                 // 0: one for each core
};

// The answer of a tool: text, and pictures as contents of the protocol.
struct Told {
  std::string text;
  std::vector<Json> pictures{};
};

// The tools that an assistant may call, and the results that it may edit, by handles such as "r1".
// Of these only parameters are kept, not motions. No tool writes a file.
class AssistantTools {
 public:
  explicit AssistantTools(AssistantSettings settings) : settings_(std::move(settings)) {}

  // The list of tools with the JSON schemas of their arguments.
  [[nodiscard]] static Json list();
  // Whether there is such a tool; else the message names the tools.
  [[nodiscard]] static Result<void> check_name(const std::string& tool);
  // Calls a tool of the list.
  [[nodiscard]] Result<Told> call(const std::string& tool, const Json& arguments,
                                  const Progress& progress);

  [[nodiscard]] Result<Told> reach(const Json& arguments, Progress progress);
  [[nodiscard]] Result<Told> edit(const Json& arguments, Progress progress);
  [[nodiscard]] Result<Told> score(const Json& arguments, Progress progress);
  [[nodiscard]] Result<Told> limit(const Json& arguments, Progress progress);
  [[nodiscard]] Result<Told> body(const Json& arguments, Progress progress);

 private:
  struct Kept {
    std::string handle;
    StoredResult result;
  };
  [[nodiscard]] Result<std::filesystem::path> file_at(const std::string& name) const;
  [[nodiscard]] Result<void> find_file(CharacterSpec& character) const;
  // The task of the argument "task"; `file` becomes its file.
  [[nodiscard]] Result<Task> task_of(const Json& arguments, TaskFile& file) const;
  // Ends a search after `seconds`, or after the longest that the settings allow.
  void limit_time(double seconds, Progress& progress) const;
  // A result in words, kept by a new handle, with a picture of its first candidate: "svg", "png" or
  // empty for none.
  [[nodiscard]] Result<Told> told(const TaskFile& file, const Task& task,
                                  const GenerateResult& generation, const std::string& picture);

  AssistantSettings settings_;
  std::deque<Kept> kept_;
  int results_ = 0;  // made so far
};

}  // namespace shigusa
