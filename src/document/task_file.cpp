// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <shigusa/files.hpp>

#include "body/joint_name.hpp"
#include "core/parse_number.hpp"
#include "core/say.hpp"
#include "criteria/built_in_criteria.hpp"
#include "files/file.hpp"
#include "plan/assignment.hpp"
#include "plan/plan.hpp"
#include "task_json.hpp"
#include "task_values.hpp"

namespace shigusa {
namespace {

// Default degrees of freedom of a person from a file: all of them, but the paper's body for the
// published method and its layers.
BodyExtent usual_extent(Preset preset) {
  return traits_of(preset).natural ? BodyExtent::human : BodyExtent::full;
}

void check_character(JsonReader& reader, const CharacterSpec& c) {
  if (const auto known = check_source(c); !known) reader.wrong("source", known.error().message);
  if (c.urdf && c.landmarks) reader.wrong("urdf", say("landmarks_beside_urdf"));
  for (const char* key :
       {"extent", "frame", "animation", "map", "doubts", "landmarks_m", "places_m", "urdf"}) {
    if (!reader.has(key) || !is_built_in(c)) continue;
    reader.wrong(key, say("of_a_file", c.source));
  }
}

void read_character(JsonReader& task, CharacterSpec& c) {
  if (!task.has("character")) return;
  if (task.value("character").is_string()) {
    task.text("character", c.source);
    if (const auto known = check_source(c); !known) task.wrong("character", known.error().message);
    return;
  }
  JsonReader reader = task.object("character");
  read_fields(reader, c);
  check_character(reader, c);
  task.absorb(reader.finish());
}

}  // namespace

Json task_to_json(const TaskFile& task) {
  Json json{{"version", task.actions.empty() ? 1 : kTaskVersion},
            {"character", fields_to_json(task.character)}};
  json.update(fields_to_json<Request>(task));
  return json;
}

Result<TaskFile> task_from_json(const Json& json, const std::string& place) {
  JsonReader reader(json, place + ": ");
  TaskFile task;
  int version = 1;
  reader.integer("version", version, 1, kTaskVersion);
  read_character(reader, task.character);
  read_fields<Request>(reader, task);
  if (version == 1) {
    for (const char* key : {"actions", "things"}) {
      if (reader.has(key)) reader.wrong(key, say("of_version_two"));
    }
  } else {
    reader.require("actions");
    if (task.actions.empty()) reader.wrong("actions", say("no_actions"));
    if (!task.goals.empty()) reader.wrong("goals", say("goals_in_actions"));
  }
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return task;
}

Result<CharacterSpec> parse_character_spec(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(Json json, parse_json(text, name));
  const Json holder{{"character", std::move(json)}};
  JsonReader reader(holder, std::string(name) + ": ");
  CharacterSpec spec;
  read_character(reader, spec);
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return spec;
}

Result<Habit> parse_habit(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(Json json, parse_json(text, name));
  const Json holder{{"habit", std::move(json)}};
  JsonReader reader(holder, std::string(name) + ": ");
  Habit habit;
  if (reader.has("habit")) read_composite(reader, "habit", habit);
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return habit;
}

Result<Habit> read_habit(const std::filesystem::path& path) {
  SHG_TRY_ASSIGN(const std::string text, read_text_file(path, kTaskMaxBytes));
  return parse_habit(text, path.filename().string());
}

std::string format_habit(const Habit& habit) { return fields_to_json(habit).dump(2) + "\n"; }

Result<Ergonomics> with_assignments(const Ergonomics& ergonomics, std::string_view assignments) {
  Json json = Json::object();
  for (std::size_t at = 0; at <= assignments.size();) {
    const std::size_t comma = std::min(assignments.find(',', at), assignments.size());
    const std::string_view part = assignments.substr(at, comma - at);
    at = comma + 1;
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string_view name = part.substr(0, equals);
    const std::size_t dot = std::min(name.find('.'), name.size());
    Json& holder = dot < name.size() ? json[std::string(name.substr(0, dot))] : json;
    if (equals == 0 || equals == part.size() || !(holder.is_null() || holder.is_object())) {
      return fail(ErrorCode::invalid_argument,
                  say("no_assignment", std::string(part.substr(0, 80)), "NAME=VALUE"));
    }
    Json& into = holder[std::string(dot < name.size() ? name.substr(dot + 1) : name)];
    const std::string_view value = part.substr(equals + 1);
    if (const auto number = parse_number(value)) {
      into = *number;
    } else if (value == "true" || value == "false") {
      into = value == "true";
    } else {
      into = std::string(value);
    }
  }
  Ergonomics changed = ergonomics;
  JsonReader reader(json, "ergonomics");
  read_fields(reader, changed);
  if (const auto error = reader.finish()) return tl::unexpected(*error);
  return changed;
}

Result<TaskFile> parse_task(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(const Json json, parse_json(text, name));
  return task_from_json(json, std::string(name));
}

Result<TaskFile> read_task(const std::filesystem::path& path) {
  SHG_TRY_ASSIGN(const std::string text, read_text_file(path, kTaskMaxBytes));
  return parse_task(text, path.filename().string());
}

std::string format_task(const TaskFile& task) {
  // names of files may hold any bytes; invalid UTF-8 is replaced
  return task_to_json(task).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<PosedBody> build_body(const TaskFile& file) {
  const auto is_right_foot = [](const std::string& name) {
    const JointPlace part = parse_joint_name(name);
    return part.side == Side::right &&
           (part.joint_kind == JointKind::foot || part.joint_kind == JointKind::ankle ||
            part.joint_kind == JointKind::toes);
  };
  const bool kept =
      !file.contacts || std::any_of(file.contacts->begin(), file.contacts->end(), is_right_foot);
  const bool moved = std::any_of(file.goals.begin(), file.goals.end(),
                                 [&](const Goal& goal) { return is_right_foot(goal.effector); });
  const bool on_both = file.contacts && file.contacts->size() > 1;
  return build_character(file.character, kept && !moved ? Side::right : Side::left, on_both);
}

Result<Task> make_task(TaskFile& file, const std::filesystem::path& folder) {
  SHG_TRY(add_scene(file, folder));
  SHG_TRY(measure_character(file.character, folder));
  if (file.character.landmarks && !file.character.extent) {
    file.character.extent = usual_extent(file.preset);
  }
  SHG_TRY_ASSIGN(PosedBody body, build_body(file));
  Task task(std::move(body), file);
  const ParameterList list = parameter_list(whole_body_plan(task.body, task.supports));
  for (const std::string& assignment : file.fixed_assignments) {
    if (!task.fixed) task.fixed = no_fixed_parameters(list);
    if (const auto done = fix_parameter(list, assignment, *task.fixed); !done) {
      return fail(done.error().code, done.error().message,
                  "fixed parameter " + assignment.substr(0, 80));
    }
  }
  return task;
}

}  // namespace shigusa
