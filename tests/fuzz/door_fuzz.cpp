// SPDX-License-Identifier: MIT
// Through the C interface's doors, as a page or a game comes in: a character from a file's bytes
// and a task for it, a result from a summary, the score of a clip. Nothing may crash, hang, fill
// the memory or be the library's own fault, and what a result tells brings it back.
//
// An input is a line of one letter and text, a second line, and a file's bytes:
//   c{"source": "hero.glb"} / a task, or nothing / the file: create, describe and generate
//   r / an edit of work, or nothing / a summary: restore, export, replay and edit
//   sclip.bvh / options, or nothing / the clip: score
// scripts/fuzz makes such inputs of the other targets' corpora and of real characters.
#include <shigusa.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace {

using Json = nlohmann::json;

// Budgets that the readers allow, but that would take seconds per input, are left to other tests.
constexpr int kMostEvaluations = 20;
constexpr std::size_t kMostCandidates = 2;
constexpr std::size_t kMostActions = 2;
constexpr double kLongest = 1.5;  // s
constexpr std::size_t kMostSummary = std::size_t{64} << 10;
constexpr std::size_t kMostClip = std::size_t{256} << 10;

struct Free {
  void operator()(shigusa_character* handle) const { shigusa_character_free(handle); }
  void operator()(shigusa_result* handle) const { shigusa_result_free(handle); }
  void operator()(shigusa_bytes* handle) const { shigusa_bytes_free(handle); }
};
using Character = std::unique_ptr<shigusa_character, Free>;
using Outcome = std::unique_ptr<shigusa_result, Free>;

void require(bool holds) {
  if (!holds) std::abort();
}

// False if the call was refused, which must be by a sentence and not by an internal error.
bool done(shigusa_status status) {
  require(status != SHIGUSA_FAULT && status != SHIGUSA_OUT_OF_MEMORY);
  require(status == SHIGUSA_OK || shigusa_message()[0] != '\0');
  return status == SHIGUSA_OK;
}

// The text that `function` returns in its last argument; "" if it fails.
template <class Function, class... Arguments>
std::string text_of(Function function, Arguments... arguments) {
  shigusa_bytes* bytes = nullptr;
  if (!done(function(arguments..., &bytes))) return {};
  const std::unique_ptr<shigusa_bytes, Free> held(bytes);
  return {shigusa_bytes_data(bytes), shigusa_bytes_size(bytes)};
}

// JSON for the look-up of budgets, without its deep parts, which contain none.
Json shallow(std::string_view text) {
  return Json::parse(
      text, [](int depth, Json::parse_event_t, Json&) { return depth < 8; }, false);
}

// Whether `object` has no number `name` above `most`.
bool at_most(const Json& object, const char* name, double most) {
  const auto found = object.find(name);
  return found == object.end() || !found->is_number() || found->get<double>() <= most;
}

// Whether all actions of a task are few and short.
bool works_quickly(const Json& task) {
  const auto actions = task.find("actions");
  if (actions == task.end()) return true;
  return actions->size() <= kMostActions && at_most(task, "candidates", 1) &&
         task.contains("candidates") &&
         std::all_of(actions->begin(), actions->end(), [](const Json& action) {
           return action.is_object() && at_most(action, "duration_s", kLongest) &&
                  at_most(action, "wait_s", kLongest) && at_most(action, "hold_s", kLongest);
         });
}

bool is_quick(const Json& task) {
  return task.is_object() && task.contains("evaluations") &&
         at_most(task, "evaluations", kMostEvaluations) && at_most(task, "duration_s", kLongest) &&
         !task.contains("generator") && works_quickly(task);
}

// The formats in which motions are written, and the page.
const std::vector<std::string>& written_formats() {
  static const std::vector<std::string> formats = [] {
    std::vector<std::string> names{"html"};
    const Json facts = Json::parse(text_of(shigusa_facts));
    for (const Json& format : facts.at("formats")) {
      if (format.at("written")) names.push_back(format.at("name"));
    }
    return names;
  }();
  return formats;
}

// All requests to a result.
void look_through(const shigusa_character* character, const shigusa_result* result) {
  const std::string summary = text_of(shigusa_result_describe, result);
  require(!summary.empty());
  for (int32_t k = 1; k <= shigusa_result_candidates(result); ++k) {
    for (const std::string& format : written_formats()) {
      (void)text_of(shigusa_result_export, result, k, format.c_str());
    }
    require(!text_of(shigusa_result_parameters, result, k).empty());
    require(!text_of(shigusa_result_action_parameters, result, k, 1).empty());
    for (shigusa_series series = SHIGUSA_TIME; series <= SHIGUSA_THINGS; ++series) {
      const double* values = nullptr;
      std::size_t frames = 0, columns = 0;
      require(done(shigusa_result_series(result, k, series, &values, &frames, &columns)));
      for (std::size_t i = 0; i < frames * columns; ++i) require(values[i] - values[i] == 0.0);
      shigusa_bytes* table = nullptr;
      shigusa_bytes* about = nullptr;
      const char* const options = R"({"fps": 12, "place": "file"})";
      require(done(shigusa_result_table(result, k, series, options, &table, &about)));
      shigusa_bytes_free(table);
      shigusa_bytes_free(about);
    }
  }
  shigusa_result* again = nullptr;
  require(done(shigusa_restore(character, summary.c_str(), &again)));
  const Outcome held(again);
  require(shigusa_result_candidates(again) == shigusa_result_candidates(result));
  if (shigusa_result_candidates(result) == 0) return;
  shigusa_result* edited = nullptr;
  require(done(shigusa_replay(again, 1, nullptr, &edited)));
  shigusa_result_free(edited);
}

void create(const std::string& spec, const std::string& task, std::string_view file) {
  shigusa_character* made = nullptr;
  const void* bytes = file.empty() ? nullptr : file.data();
  if (!done(shigusa_character_create(spec.c_str(), bytes, file.size(), &made))) return;
  const Character character(made);
  require(!text_of(shigusa_character_describe, made).empty());
  if (!is_quick(shallow(task))) return;
  shigusa_result* result = nullptr;
  if (!done(shigusa_generate(made, task.c_str(), 1, nullptr, &result))) return;
  const Outcome held(result);
  look_through(made, result);
}

void restore(const std::string& edit, const std::string& summary) {
  if (summary.size() > kMostSummary) return;
  const Json told = shallow(summary);
  if (!told.is_object() || !told.contains("task") || !told.contains("candidates")) return;
  if (told["candidates"].size() > kMostCandidates || !told["task"].is_object()) return;
  if (!at_most(told["task"], "duration_s", kLongest) || !works_quickly(told["task"]) ||
      told["task"].contains("generator"))
    return;
  shigusa_result* result = nullptr;
  if (!done(shigusa_restore(nullptr, summary.c_str(), &result))) return;
  const Outcome held(result);
  look_through(nullptr, result);
  if (edit.empty() || !is_quick(told["task"])) return;
  shigusa_result* edited = nullptr;
  if (!done(shigusa_replay_work(result, 1, edit.c_str(), nullptr, &edited))) return;
  const Outcome held_too(edited);
  look_through(nullptr, edited);
}

void score(const std::string& name, const std::string& options, std::string_view clip) {
  if (clip.size() > kMostClip) return;
  (void)text_of(shigusa_score_clip, name.c_str(), clip.data(), clip.size(),
                options.empty() ? nullptr : options.c_str());
}

// Removes the first line from the text and returns it.
std::string take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.size(), line.size() + 1));
  return std::string(line);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  const std::string first = take_line(rest);
  const std::string second = take_line(rest);
  if (first.empty()) return 0;
  const std::string text = first.substr(1);
  if (first[0] == 'c') create(text, second, rest);
  if (first[0] == 'r') restore(second, std::string(rest));
  if (first[0] == 's') score(text, second, rest);
  return 0;
}
