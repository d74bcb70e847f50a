// SPDX-License-Identifier: MIT
#include "assistant_tools.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <shigusa/character.hpp>
#include <shigusa/draw.hpp>
#include <shigusa/edit.hpp>
#include <shigusa/explore.hpp>
#include <shigusa/score.hpp>
#include <system_error>

#include "files/path.hpp"
#include "formats/base64.hpp"
#include "formats/json_reader.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kCandidatesTold = 8;
constexpr std::size_t kReasonsTold = 3;

struct Tool {
  const char* name;
  const char* about;
  // properties of its arguments as JSON, and those that are required; the task's schema is put in
  // for "@task"
  const char* properties;
  std::vector<std::string> required;
  Result<Told> (AssistantTools::*call)(const Json&, Progress);
};

const std::array<Tool, 5>& tools() {
  static const std::array<Tool, 5> all{{
      {"reach",
       "Finds motions for a task and keeps them by a handle, r1, r2, …: of each candidate the "
       "verdict, the score (less is better), how it ends, and why it strains or is impossible.",
       R"({"task": "@task",
           "seconds": {"type": "number", "description": "Longest search, 300 when not given."},
           "picture": {"enum": ["svg", "png"], "description": "Also draws the first candidate."}})",
       {"task"},
       &AssistantTools::reach},
      {"edit",
       "Changes a candidate of a kept result, without a search unless `again`, `keep` or `seed` "
       "ask for one, and keeps the new result. Without a change it lists the parameters.",
       R"({"result": {"type": "string", "description": "The handle, such as r1."},
           "candidate": {"type": "integer", "minimum": 1, "description": "1 when not given."},
           "set": {"type": "array", "items": {"type": "string"},
                   "description": "Assignments such as squat_deg=60 or right_knee.weight=3."},
           "action": {"type": "integer", "minimum": 1,
                      "description": "Of a task with actions: the one whose motion `set` changes."},
           "again": {"type": "array", "items": {"type": "integer"},
                     "description": "Actions that are searched anew."},
           "keep": {"type": "array", "items": {"type": "integer"},
                    "description": "Actions that stay; all others are searched anew."},
           "seed": {"type": "integer", "minimum": 0},
           "picture": {"enum": ["svg", "png"]}})",
       {"result"},
       &AssistantTools::edit},
      {"score",
       "Scores a recorded motion on its own person: BVH as `text`, any clip (BVH, GLB, VRM, VRMA) "
       "as `base64`, or a `file` below the folder that the server was given.",
       R"({"name": {"type": "string", "description": "Name with its ending, clip.bvh for text."},
           "text": {"type": "string"}, "base64": {"type": "string"}, "file": {"type": "string"},
           "options": {"type": "object", "description": "criteria, first, last, smoothed_hz, animation, cost, ergonomics, character."}})",
       {},
       &AssistantTools::score},
      {"limit",
       "Finds how far a task can go: the heaviest load of its hands (kg), or the lowest, highest "
       "or farthest place of its goals (m). Takes minutes at times.",
       R"({"task": {"type": "object", "description": "A task as reach takes it."},
           "of": {"enum": ["load", "lowest", "highest", "farthest"]},
           "score": {"type": "number", "description": "Highest score that counts as possible."},
           "bound": {"type": "number", "description": "Last value tried, kg or m."},
           "seeds": {"type": "integer", "minimum": 1, "maximum": 20},
           "thing": {"type": "string", "description": "Of a task with actions: what gets heavier."},
           "seconds": {"type": "number"}})",
       {"task", "of"},
       &AssistantTools::limit},
      {"body",
       "Describes a body: stature, mass, joints with their limits, and where the points that goals "
       "can be given for start.",
       R"({"character": {"type": ["string", "object"], "description": "As in a task, human when not given."}})",
       {},
       &AssistantTools::body},
  }};
  return all;
}

// The schema of tasks without the definitions that it refers to, which go to `definitions`.
Json task_part(Json& definitions) {
  Json schema = Json::parse(task_schema());
  definitions = schema["$defs"];
  schema.erase("$schema");
  schema.erase("$defs");
  return schema;
}

void add_line(std::string& text, const std::string& line) {
  text += line;
  text += '\n';
}

std::string verdict_line(const Judgement& judgement, const Score& score,
                         const FinalPosture& posture) {
  std::string text = fmt::format("{}, score {:.4f}, ends as {}", word_of(judgement.verdict),
                                 score.total, posture_words(posture));
  for (std::size_t i = 0; i < std::min(kReasonsTold, judgement.reasons.size()); ++i) {
    text += "; " + reason_words(judgement.reasons[i]);
  }
  if (judgement.possible_in) text += "; " + enough_words(*judgement.possible_in) + " would do";
  return text;
}

// The parameters that an edit may set; weights, of which each joint has one, by the first.
std::string parameter_lines(const std::vector<EditableParameter>& parameters) {
  std::string text = "parameters, with their usual ranges:\n";
  std::size_t weights = 0;
  for (const EditableParameter& each : parameters) {
    if (each.kind == EditableKind::weight && ++weights > 1) continue;
    add_line(text, fmt::format("{}={:.4g} ({:g} to {:g}) {}", each.name, each.value, each.low,
                               each.high, each.sentence));
  }
  if (weights > 1) add_line(text, fmt::format("and so on, a weight of {} freedoms", weights));
  return text;
}

}  // namespace

Json AssistantTools::list() {
  Json all = Json::array();
  for (const Tool& tool : tools()) {
    Json properties = Json::parse(tool.properties);
    Json schema{{"type", "object"}};
    Json definitions;
    if (properties.contains("task") && properties["task"] == "@task") {
      properties["task"] = task_part(definitions);
    }
    schema["properties"] = std::move(properties);
    schema["required"] = tool.required;
    schema["additionalProperties"] = false;
    if (!definitions.is_null()) schema["$defs"] = std::move(definitions);
    all.push_back(
        {{"name", tool.name}, {"description", tool.about}, {"inputSchema", std::move(schema)}});
  }
  return all;
}

Result<void> AssistantTools::check_name(const std::string& name) {
  std::vector<std::string> names;
  for (const Tool& tool : tools()) names.emplace_back(tool.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return {};
  return fail(ErrorCode::not_found, unknown_name("tool", name, names), "tools/call");
}

Result<Told> AssistantTools::call(const std::string& name, const Json& arguments,
                                  const Progress& progress) {
  const auto& all = tools();
  const auto tool =
      std::find_if(all.begin(), all.end(), [&](const Tool& each) { return each.name == name; });
  return (this->*tool->call)(arguments, progress);
}

Result<Told> AssistantTools::reach(const Json& arguments, Progress progress) {
  JsonReader reader(arguments, "reach: ");
  double seconds = settings_.seconds;
  std::string picture;
  reader.number("seconds", seconds, 1e-3, 1e6);
  reader.choice("picture", picture, {{"svg", "svg"}, {"png", "png"}});
  (void)reader.has("task");
  reader.require("task");
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  TaskFile file;
  SHG_TRY_ASSIGN(const Task task, task_of(arguments, file));
  limit_time(seconds, progress);
  SHG_TRY_ASSIGN(const GenerateResult generation,
                 task.actions.empty() ? generate(task, progress) : perform(task, progress));
  return told(file, task, generation, picture);
}

Result<Told> AssistantTools::edit(const Json& arguments, Progress progress) {
  JsonReader reader(arguments, "edit: ");
  std::string handle;
  std::string picture;
  int candidate = 1;
  reader.text("result", handle);
  reader.require("result");
  reader.integer("candidate", candidate, 1, kResultMaxCandidates);
  reader.choice("picture", picture, {{"svg", "svg"}, {"png", "png"}});
  Json change = Json::object();
  for (const char* key : {"action", "set", "again", "keep", "seed"}) {
    if (reader.has(key)) change[key] = reader.value(key);
  }
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  SHG_TRY_ASSIGN(const WorkEdit edit, parse_work_edit(change.dump(), "edit"));
  std::vector<std::string> handles;
  for (const Kept& kept : kept_) handles.push_back(kept.handle);
  const auto found = std::find(handles.begin(), handles.end(), handle);
  if (found == handles.end()) {
    return fail(ErrorCode::not_found, unknown_name("result", handle, handles), "edit");
  }
  StoredResult stored = kept_[static_cast<std::size_t>(found - handles.begin())].result;
  SHG_TRY_ASSIGN(Task task, make_task(stored.task, {}));
  task.batch.threads = settings_.threads;
  limit_time(settings_.seconds, progress);
  Result<GenerateResult> generation = [&]() -> Result<GenerateResult> {
    if (!task.actions.empty()) return replay_work(task, stored, candidate, edit, progress);
    if (change.size() > change.count("set")) {
      return fail(ErrorCode::invalid_argument, "the result's task has no actions",
                  "action, again, keep, seed");
    }
    SHG_TRY_ASSIGN(MotionPlayer player, MotionPlayer::of(task));
    return replay(player, stored, candidate, edit.assignments);
  }();
  if (!generation) return tl::unexpected(generation.error());
  SHG_TRY_ASSIGN(Told made, told(stored.task, task, *generation, picture));
  if (change.empty()) {
    const Candidate& first = generation->candidates.front();
    made.text += parameter_lines(
        task.actions.empty() ? editable_parameters(*generation->parameters, first.parameters)
                             : action_parameters(*generation->parameters, first, 1));
  }
  return made;
}

Result<Told> AssistantTools::score(const Json& arguments, Progress) {
  JsonReader reader(arguments, "score: ");
  std::string name = "clip.bvh";
  std::string text;
  std::string encoded;
  std::string path;
  reader.text("name", name);
  reader.text("text", text);
  reader.text("base64", encoded);
  reader.text("file", path);
  const std::string options = reader.has("options") ? reader.value("options").dump() : "{}";
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  if ((text.empty() ? 0 : 1) + (encoded.empty() ? 0 : 1) + (path.empty() ? 0 : 1) != 1) {
    return fail(ErrorCode::invalid_argument, "give one of text, base64 and file", "score");
  }
  SHG_TRY_ASSIGN(ClipRequest request, parse_clip_request(options, "options"));
  CharacterSpec character;
  if (request.character) {
    character = *request.character;
    SHG_TRY(find_file(character));
  } else {
    character.source = path.empty() ? name : path;
    character.frame = request.settings.first;
  }
  Result<RecordedMotion> recorded = [&]() -> Result<RecordedMotion> {
    const int first = request.settings.first;
    if (!path.empty()) {
      SHG_TRY_ASSIGN(const fs::path file, file_at(path));
      if (character.source == path) character.source = file.string();
      return read_recorded(file, character, first, request.animation);
    }
    const std::optional<std::string> bytes = encoded.empty() ? text : from_base64(encoded);
    if (!bytes) return fail(ErrorCode::parse, "is no base64", "score: base64");
    return parse_recorded(*bytes, name, character, first, request.animation);
  }();
  if (!recorded) return tl::unexpected(recorded.error());
  SHG_TRY_ASSIGN(const ClipScore score, score_clip(*recorded, request.settings));
  const BodyModel& body = recorded->body;
  Told told{fmt::format("{}: {:.3f} m, {:.1f} kg; {:.2f} s\n", body.name(), body.stature(),
                        body.mass(), score.motion.clip.duration())};
  add_line(told.text, verdict_line(judge(body, score.measures), score.score, score.final_posture));
  add_line(told.text,
           fmt::format("the body's joints are {:.2f} cm from the recorded ones on average",
                       100.0 * score.fit.mean_distance));
  for (const ScoreTerm& term : score.score.terms) {
    add_line(told.text,
             fmt::format("{}: {:.4f} of weight {:g}", term.name, term.penalty, term.weight));
  }
  for (const Message& doubt : recorded->doubts) add_line(told.text, "note: " + doubt.text);
  for (const Message& doubt : score.doubts) add_line(told.text, "note: " + doubt.text);
  return told;
}

Result<Told> AssistantTools::limit(const Json& arguments, Progress progress) {
  JsonReader reader(arguments, "limit: ");
  LimitSettings settings;
  double seconds = settings_.seconds;
  reader.choice("of", settings.kind,
                {{"load", LimitKind::load},
                 {"lowest", LimitKind::lowest},
                 {"highest", LimitKind::highest},
                 {"farthest", LimitKind::farthest}});
  if (reader.has("score")) reader.number("score", settings.score.emplace(), 1e-6, 1e6);
  if (reader.has("bound")) reader.number("bound", settings.bound.emplace(), 0.0, kLoadMax);
  reader.integer("seeds", settings.seeds, 1, kLimitSeedsMax);
  reader.text("thing", settings.thing);
  reader.number("seconds", seconds, 1e-3, 1e6);
  (void)reader.has("task");
  reader.require("task");
  reader.require("of");
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  TaskFile file;
  SHG_TRY_ASSIGN(const Task task, task_of(arguments, file));
  limit_time(seconds, progress);
  SHG_TRY_ASSIGN(const Limit limit, find_limit(task, settings, progress));
  const std::string_view unit = limit_unit(limit.kind);
  if (limit.end == LimitEnd::nowhere) {
    return Told{fmt::format("{}: no value that was tried is possible, from {:.4g} {} on",
                            word_of(limit.kind), limit.value, unit)};
  }
  Told told{fmt::format("{}: {}{:.4g} {}", word_of(limit.kind), limit.sharp ? "" : "about ",
                        limit.value, unit)};
  if (limit.end == LimitEnd::beyond) told.text += ", the last value that was tried";
  if (limit.out_of_reach) told.text += "; beyond it the goal is out of reach";
  if (limit.reason) told.text += "; beyond it: " + reason_words(*limit.reason);
  if (limit.again) told.text += fmt::format("; possible again at {:.4g} {}", *limit.again, unit);
  return told;
}

Result<Told> AssistantTools::body(const Json& arguments, Progress) {
  JsonReader reader(arguments, "body: ");
  CharacterSpec spec;
  if (reader.has("character")) {
    SHG_TRY_ASSIGN(spec, parse_character_spec(reader.value("character").dump(), "character"));
  }
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  SHG_TRY(find_file(spec));
  SHG_TRY(measure_character(spec, {}));
  SHG_TRY_ASSIGN(const PosedBody posed, build_character(spec));
  const BodyModel& body = posed.body;
  Told told{fmt::format("{}: {:.3f} m, {:.1f} kg, {} degrees of freedom\n", body.name(),
                        body.stature(), body.mass(), body.dof_count())};
  add_line(told.text, "goals can be given for, with the start in m:");
  for (const GoalPlace& place : goal_places(posed)) {
    const Vec3d at = place.start + Vec3d{};  // no -0
    add_line(told.text, fmt::format("{} {:.3f} {:.3f} {:.3f}", place.effector, at.x, at.y, at.z));
  }
  add_line(told.text, "degrees of freedom, with limits in degrees:");
  for (const Dof& dof : body.dofs()) {
    add_line(told.text,
             fmt::format("{} {:.0f} to {:.0f}", dof.name, degrees(dof.lower), degrees(dof.upper)));
  }
  for (const Message& doubt : posed.doubts) add_line(told.text, "note: " + doubt.text);
  return told;
}

Result<fs::path> AssistantTools::file_at(const std::string& name) const {
  if (settings_.folder.empty()) {
    return fail(ErrorCode::invalid_argument,
                "no file is read, as the server was started without --folder; give what it holds",
                name.substr(0, 200));
  }
  std::error_code wrong;
  const fs::path folder = fs::canonical(settings_.folder, wrong);
  const fs::path named = to_path(name);
  // one of another machine is not even looked for
  const bool elsewhere = named.has_root_name() && named.root_name() != folder.root_name();
  const fs::path path = elsewhere ? named : fs::weakly_canonical(folder / named, wrong);
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  if (!wrong && end == folder.end() && rest != path.end()) return path;
  return fail(ErrorCode::invalid_argument, "is not below the server's folder", name.substr(0, 200));
}

Result<void> AssistantTools::find_file(CharacterSpec& character) const {
  if (is_complete(character)) return {};
  SHG_TRY(check_source(character));
  SHG_TRY_ASSIGN(const fs::path path, file_at(character.source));
  character.source = path.string();
  return {};
}

Result<Task> AssistantTools::task_of(const Json& arguments, TaskFile& file) const {
  const std::string text = arguments["task"].dump();
  if (text.size() > kTaskMaxBytes) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} bytes; allowed are {}", text.size(), kTaskMaxBytes), "task");
  }
  SHG_TRY_ASSIGN(file, parse_task(text, "task"));
  SHG_TRY(find_file(file.character));
  if (!file.scene.empty()) {
    SHG_TRY_ASSIGN(const fs::path scene, file_at(file.scene));
    file.scene = scene.string();
  }
  SHG_TRY_ASSIGN(Task task, make_task(file, {}));
  task.batch.threads = settings_.threads;
  return task;
}

void AssistantTools::limit_time(double seconds, Progress& progress) const {
  using Clock = std::chrono::steady_clock;
  progress.deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(
                         std::chrono::duration<double>(std::min(seconds, settings_.seconds)));
}

Result<Told> AssistantTools::told(const TaskFile& file, const Task& task,
                                  const GenerateResult& generation, const std::string& picture) {
  Told told;
  const std::vector<Candidate>& candidates = generation.candidates;
  if (!picture.empty() && !candidates.empty()) {
    SHG_TRY_ASSIGN(const FileFormat format, value_of<FileFormat>(picture, "format"));
    SHG_TRY_ASSIGN(const std::string drawn,
                   export_candidate(file.character, task, candidates.front(), format,
                                    {.from_svg = settings_.from_svg}));
    const std::string type(info_of(format).media_type);
    const std::string uri = fmt::format("shigusa://r{}/candidate-1.{}", results_ + 1, picture);
    told.pictures.push_back(
        format == FileFormat::png
            ? Json{{"type", "image"}, {"mimeType", type}, {"data", to_base64(drawn)}}
            : Json{{"type", "resource"},
                   {"resource", {{"uri", uri}, {"mimeType", type}, {"text", drawn}}}});
  }
  kept_.push_back({fmt::format("r{}", ++results_), stored_result(file, generation)});
  if (kept_.size() > kAssistantResultsMost) kept_.pop_front();
  add_line(told.text, fmt::format("{}: {}; {}, {}; {:.2f} s of motion", kept_.back().handle,
                                  word_of(generation.status), task.body.name(), asked_words(task),
                                  generation.duration));
  for (std::size_t i = 0; i < std::min(kCandidatesTold, candidates.size()); ++i) {
    const Candidate& each = candidates[i];
    add_line(told.text, fmt::format("candidate {}: {}", i + 1,
                                    verdict_line(each.judgement, each.score, each.final_posture)));
  }
  if (candidates.size() > kCandidatesTold) {
    add_line(told.text, fmt::format("and {} more", candidates.size() - kCandidatesTold));
  }
  if (!generation.meets_goals()) {
    add_line(told.text,
             fmt::format("out of reach: the closest motion ends {:.1f} mm from the goals",
                         1e3 * generation.remaining_distance));
    if (!generation.conflict.empty()) add_line(told.text, generation.conflict.text);
  }
  if (generation.end == SearchEnd::cancelled) add_line(told.text, "the search was stopped early");
  for (const Message& note : goal_notes(task)) add_line(told.text, "note: " + note.text);
  for (const Message& doubt : task.doubts) add_line(told.text, "note: " + doubt.text);
  return told;
}

}  // namespace shigusa
