// SPDX-License-Identifier: MIT
#include "task_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <shigusa/error.hpp>

#include "files/path.hpp"
#include "next_step.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

Result<void> apply_options(const TaskInput& input, TaskFile& file) {
  if (input.character) {
    file.character = {};
    file.character.source = *input.character;
  }
  SHG_TRY(apply_character_options(input.person, file.character));
  if (!input.goal_of.empty() && file.goals.empty() && !input.asked.has("--goal")) {
    file.goals.push_back({.effector = input.goal_of});
  }
  auto applied = apply_task_options(input.asked, file);
  if (!applied || !input.asked.has("--layer-reading") || traits_of(file.preset).layers) {
    return applied;
  }
  return fail(
      ErrorCode::invalid_argument,
      fmt::format("is of the presets layers and human, and the preset is {}", word_of(file.preset)),
      "--layer-reading");
}

// Adds a hint to an error about a task file that was meant as a goal or a character.
Error about_task(const Error& error, const std::string& task) {
  std::error_code ignored;
  const std::string& text = error.message.text;
  std::string hint;
  if (!std::filesystem::exists(to_path(task), ignored)) {
    if (task.find('=') != task.npos) {
      hint = "; a goal is given by --goal " + task;
    } else if (task.find_first_not_of("0123456789.,-+") == task.npos) {
      hint = "; a goal is EFFECTOR=X,Y,Z: --goal right_hand=" + task;
    } else if (parse_formats(task)) {
      hint = "; formats are joined by commas, as in --formats bvh,glb";
    }
  } else if (std::filesystem::is_directory(to_path(task), ignored)) {
    hint = "; a task file (JSON) is expected";
  } else if (error.code == ErrorCode::parse && format_of_file(task)) {
    hint = "; a task file is JSON, and a character is given by --character " + task;
  } else if (text.starts_with("not JSON") || text == "the file is empty") {
    hint = "; `shigusa schema` prints what a task file holds";
  }
  return {error.code, text + hint, error.place};
}

Result<TaskFile> file_of(const TaskInput& input) {
  if (input.task.empty()) return TaskFile{};
  Result<TaskFile> file = read_task(to_path(input.task));
  if (!file) return tl::unexpected(about_task(file.error(), input.task));
  return file;
}

// Distance (m) beyond any reach: the numbers are in another unit.
constexpr double kFarAway = 5.0;  // m

// Hint for a goal that is far away, converted from centimetres or millimetres.
void note_other_units(const TaskFile& file) {
  for (const Goal& goal : file.goals) {
    const Vec3d& at = goal.position;
    const double far = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)});
    if (!(far > kFarAway) || !std::isfinite(far)) continue;
    const double unit = far <= 100.0 * kFarAway ? 100.0 : 1000.0;
    note("goal of " + goal.effector,
         fmt::format("{:g},{:g},{:g} are metres, a place {:.0f} m away; if {} are meant, give "
                     "{:g},{:g},{:g}",
                     at.x, at.y, at.z, norm(at), unit == 100.0 ? "centimetres" : "millimetres",
                     at.x / unit, at.y / unit, at.z / unit));
  }
}

// Whether a person of that height could reach a place, so that it is plausible.
bool looks_near(const Vec3d& place, double stature) {
  return place.y >= 0.0 && place.y <= 1.3 * stature &&
         norm(Vec3d{place.x, 0.0, place.z}) <= 0.75 * stature;
}

}  // namespace

Result<SimdSet> simd_named(const std::string& name) {
  std::vector<std::string> names;
  for (const SimdSet set : usable_simd_sets()) {
    if (name == simd_name(set)) return set;
    names.emplace_back(simd_name(set));
  }
  return fail(ErrorCode::invalid_argument,
              unknown_name("SIMD set, or one that this machine lacks,", name, names), "--simd");
}

std::string simd_choices() {
  // all SIMD sets, so that the help text is the same on every machine
  std::vector<std::string_view> names;
  for (const SimdSet set : {SimdSet::scalar, SimdSet::lanes_4, SimdSet::avx2, SimdSet::avx512}) {
    names.push_back(simd_name(set));
  }
  return fmt::format("{}", fmt::join(names, "|"));
}

Result<BatchSettings> batch_settings(const TaskInput& input) {
  BatchSettings batch;
  batch.threads = input.threads;
  if (input.simd) {
    SHG_TRY_ASSIGN(batch.simd, simd_named(*input.simd));
  }
  return batch;
}

Result<TaskFile> task_file_of(const TaskInput& input) {
  SHG_TRY_ASSIGN(TaskFile file, file_of(input));
  SHG_TRY(apply_options(input, file));
  // files on the command line are relative to the working directory
  if (input.asked.has("--scene"))
    file.scene = std::filesystem::absolute(to_path(file.scene)).string();
  note_other_units(file);
  return file;
}

std::filesystem::path folder_of(const TaskInput& input) {
  if (input.character || input.task.empty()) return {};
  return to_path(input.task).parent_path();
}

Error in_task(const Error& error, const TaskInput& input, const char* command) {
  if (input.task.empty() && error.message.key == "no_goal") {
    return {error.code,
            fmt::format("no goal: give one, such as --goal {}, or a task file (JSON)",
                        option_example("--goal")),
            command};
  }
  if (input.task.empty() || input.asked.has("--goal")) return error;
  return {error.code, error.to_string(), to_path(input.task).filename().string()};
}

void note_other_axes(const Task& task) {
  for (const Goal& goal : task.goals) {
    const Vec3d& at = goal.position;
    const Vec3d other{at.y, at.z, at.x};
    if (looks_near(at, task.body.stature()) || !looks_near(other, task.body.stature())) continue;
    note("goal of " + goal.effector,
         fmt::format("X is to the left, Y up and Z ahead; if x ahead, y left, z up are meant, give "
                     "{}={:g},{:g},{:g}",
                     goal.effector, other.x, other.y, other.z));
  }
}

void add_task_input(CLI::App& c, TaskInput& o) {
  describe(c.add_option("task", o.task),
           {.brief = "Task file (JSON); options take precedence over it", .form = "FILE"});
  describe(c.add_option("--character", o.character),
           {.group = heading(OptionGroup::body),
            .brief = fmt::format("Who moves (default {}); a file is a person's or a robot's",
                                 kBuiltInCharacters.front()),
            .full = "Who moves: " + character_help(),
            .form = character_form()});
  add_character_options(c, o.person);
  add_task_options(c, o.asked);
}

void add_batch_options(CLI::App& c, TaskInput& o) {
  const std::string group = heading(OptionGroup::search);
  describe(c.add_option("--threads", o.threads)->check(whole_number(0, kMaxThreads)),
           {.group = group,
            .brief = "Threads of the search (default 0: one for each core)",
            .full = "Threads of the search; 0, when not given, is one for each core. Results do "
                    "not depend on it.",
            .form = "N",
            .rare = true});
  describe(c.add_option("--simd", o.simd),
           {.group = group,
            .brief = "Instructions of the search (default: the widest)",
            .full = "Instructions of the search; the widest of the machine when not given. Results "
                    "do not depend on it.",
            .form = simd_choices(),
            .rare = true});
}

}  // namespace shigusa::app
