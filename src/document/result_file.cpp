// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <shigusa/files.hpp>
#include <shigusa/run.hpp>
#include <shigusa/score.hpp>

#include "character/character_rig.hpp"
#include "character_export.hpp"
#include "core/say.hpp"
#include "cost_json.hpp"
#include "formats/message_json.hpp"
#include "measures_json.hpp"
#include "parameters_json.hpp"
#include "task_json.hpp"

namespace shigusa {
namespace {

// Node of the exported file for a node of the body: the character's own, if it has a rig.
Json joint_of(const CharacterSpec& character, const std::string& body_node) {
  const int node = rig_node(character, body_node);
  if (node < 0) return body_node;
  return character.rig->skeleton.nodes[static_cast<std::size_t>(node)].name;
}

// Adds the index of the glTF node. Names in glTF may repeat or be missing; indices are unique.
void add_gltf_node(const CharacterSpec& character, const std::string& body_node, Json& json) {
  const int node = rig_node(character, body_node);
  if (node < 0 || character.rig->file_node.empty()) return;
  json["gltf_node"] = character.rig->file_node[static_cast<std::size_t>(node)];
}

Json goals_to_json(const CharacterSpec& character, const std::vector<GoalResult>& goals) {
  Json list = Json::array();
  for (const GoalResult& goal : goals) {
    list.push_back({{"effector", goal.asked.effector},
                    {"joint", joint_of(character, goal.node)},
                    {"goal_m", to_json(goal.asked.position)},
                    {"reached_m", to_json(goal.reached)},
                    {"error_mm", goal.error * kMillimetres}});
    const Vec3d& tolerance = goal.asked.tolerance;
    if (tolerance != Vec3d{}) list.back()["tolerance_m"] = to_json(tolerance);
    list.back()["start_rotation_xyzw"] = to_json(goal.turn.start);
    list.back()["rotation_xyzw"] = to_json(goal.turn.reached);
    if (goal.turn.error) list.back()["rotation_error_deg"] = degrees(*goal.turn.error);
    add_gltf_node(character, goal.node, list.back());
  }
  return list;
}

// The goals that are met in the last frame: of work those of the last action that moves, without
// the boxes of standing up.
std::vector<GoalResult> met_at_end(const Candidate& candidate) {
  if (candidate.actions.empty()) return candidate.goals;
  std::vector<GoalResult> goals;
  for (auto action = candidate.actions.rbegin(); action != candidate.actions.rend(); ++action) {
    if (action->goals.empty()) continue;
    goals = action->goals;
    if (action->kind == ActionKind::stand) {
      std::erase_if(goals, [](const auto& goal) { return goal.asked.tolerance != Vec3d{}; });
    }
    break;
  }
  return goals;
}

Json paths_to_json(const Candidate& candidate) {
  Json list = Json::array();
  for (const GoalResult& goal : candidate.goals) {
    list.push_back({{"effector", goal.asked.effector}, {"kind", word_of(goal.path)}});
  }
  return list;
}

Json contacts_to_json(const CharacterSpec& character, const Candidate& candidate) {
  Json list = Json::array();
  for (const ContactResult& contact : candidate.contacts) {
    list.push_back({{"effector", contact.effector},
                    {"joint", joint_of(character, contact.node)},
                    {"max_slide_mm", contact.max_slide * kMillimetres}});
    if (contact.heel) {
      list.back()["heel_lift_deg"] = degrees(contact.heel->angle);
      list.back()["heel_lift_mm"] = contact.heel->height * kMillimetres;
    }
    add_gltf_node(character, contact.node, list.back());
  }
  return list;
}

// Adds the time for which a foot stands: all of it, as feet do not move.
void add_times(double duration, Json& contacts) {
  for (Json& contact : contacts) {
    contact["from_s"] = 0.0;
    contact["to_s"] = duration;
  }
}

Json actions_to_json(const FinishedRun& run, const Candidate& candidate) {
  Json list = Json::array();
  for (const ActionResult& action : candidate.actions) {
    Json& json = list.emplace_back();
    json["kind"] = word_of(action.kind);
    json["start_s"] = action.start;
    json["end_s"] = action.end;
    json["reached"] = goals_to_json(run.file.character, action.goals);
    json["steps"] = 0;
    json["verdict"] = word_of(action.judgement.verdict);
    json["reasons"] = reasons_to_json(action.judgement);
    json["score"] = action.score.total;
    json["criteria"] = penalties_to_json(action.score);
    if (const auto& placed = action.placed) {
      json["placed"] = placed_to_json(*placed);
    }
  }
  return list;
}

Json motions_to_json(const ParameterList& list, const Candidate& candidate) {
  Json json = Json::array();
  for (const WorkMotion& motion : candidate.motions) {
    json.push_back({{"action", motion.action + 1},
                    {"way", motion.way},
                    {"duration_s", motion.duration},
                    {"parameters", parameters_to_json(list, motion.values)}});
    if (motion.approach >= 0) json.back()["approach"] = motion.approach;
  }
  return json;
}

Json resting_to_json(const CharacterSpec& character, const Candidate& candidate) {
  Json list = Json::array();
  for (const RestResult& rest : candidate.resting) {
    list.push_back({{"effector", rest.effector},
                    {"joint", joint_of(character, rest.node)},
                    {"on", rest.on},
                    {"max_slide_mm", rest.max_slide * kMillimetres},
                    {"force_N", rest.force}});
    add_gltf_node(character, rest.node, list.back());
  }
  return list;
}

// Adds the files of a candidate, with the rate and the frames of those that have the rate asked
// for.
void add_files(const Candidate& candidate, const CandidateFiles& files, double rate, bool robot,
               Json& json) {
  json["files"] = Json::object();
  for (const auto& [format, file] : files) {
    json["files"][format] = file.name;
    if (!file.sha256.empty()) json["sha256"][format] = file.sha256;
    const auto known = value_of<FileFormat>(format, "format");
    const bool rated = known && (info_of(*known).rated || (robot && *known == FileFormat::csv));
    // where none was asked for, formats without nodes have frames of their own
    if (!rated || (rate == kUsualRate && !file.read_back)) continue;
    json["fps"] = rate;
    json["file_frames"] = frames_at(candidate.motion.clip.duration(), rate);
    if (!file.read_back) continue;
    json["read_back"][format] = {{"effector_mm", file.read_back->effector * kMillimetres},
                                 {"feet_mm", file.read_back->feet * kMillimetres},
                                 {"turn_deg", degrees(file.read_back->turn)}};
  }
}

Json candidate_to_json(const FinishedRun& run, std::size_t index, const ResultFiles& files) {
  const CharacterSpec& character = run.file.character;
  const Candidate& candidate = run.generation.candidates[index];
  Json json;
  json["rank"] = index + 1;
  json["verdict"] = word_of(candidate.judgement.verdict);
  json["reasons"] = reasons_to_json(candidate.judgement);
  if (candidate.judgement.possible_in) json["possible_in_s"] = *candidate.judgement.possible_in;
  json["score"] = candidate.score.total;
  json["criteria"] = penalties_to_json(candidate.score);
  json["reached"] = goals_to_json(character, met_at_end(candidate));
  json["paths"] = paths_to_json(candidate);
  json["path_error_mm"] = candidate.path_error * kMillimetres;
  json["contacts"] = contacts_to_json(character, candidate);
  if (!candidate.resting.empty()) json["resting"] = resting_to_json(character, candidate);
  add_measures(run.task.body, candidate.measures, candidate.final_posture, json);
  json["final_posture"]["elbow_swivel_deg"] = degrees(candidate.final_posture.elbow_swivel);
  const bool works = !candidate.actions.empty();
  if (works) {
    json["actions"] = actions_to_json(run, candidate);
    json["motions"] = motions_to_json(*run.generation.parameters, candidate);
    add_times(candidate.motion.clip.duration(), json["contacts"]);
  }
  json["duration_s"] = works ? candidate.motion.clip.duration() : run.generation.duration;
  json["frames"] = candidate.motion.clip.frames;
  if (const std::optional<ArmCollision>& arms = candidate.arm_collision) {
    json["arm_collision"] = {{"depth_mm", max(arms->depth, 0.0) * kMillimetres},
                             {"searches", arms->searches},
                             {"left", arms->left}};
  }
  if (!run.costs.empty()) {
    json["cost"] = cost_to_json(run.costs[index], ergonomics_of(run.task, character.sex));
  }
  json["parameters"] = parameters_to_json(*run.generation.parameters, candidate.parameters);
  const bool written = index < files.candidates.size();
  const CandidateFiles& own = written ? files.candidates[index] : CandidateFiles{};
  add_files(candidate, own, files.rate, run.task.robot.has_value(), json);
  if (own.contains("glb")) {
    json["glb_animation"] = candidate_animation(character, index + 1);
    json["glb_unit_m"] = node_unit(character);
  }
  json["bvh_unit_m"] = bvh_unit(character);
  return json;
}

Json search_to_json(const GenerateResult& generation) {
  Json json{{"end", word_of(generation.end)},
            {"generations", generation.log.generations},
            {"missed", generation.log.missed},
            {"collided", generation.log.collided},
            {"near_copies", generation.log.near_copies},
            {"rejected_nan", generation.log.rejected_nan},
            {"replay_differs", generation.log.replay_differs},
            {"replay_difference", generation.log.replay_difference}};
  if (generation.best_seen) {
    json["best_seen"] = {
        {"score", generation.best_seen_score},
        {"parameters", parameters_to_json(*generation.parameters, *generation.best_seen)}};
  }
  return json;
}

// Whether a name is that of a file directly in the result's folder.
bool is_plain_name(const std::string& name) {
  constexpr std::size_t kLongest = 255;
  return !name.empty() && name.size() <= kLongest && name != "." && name != ".." &&
         name.find_first_of(std::string("/\\\0", 3)) == name.npos;
}

bool is_sha256(const std::string& text) {
  constexpr std::size_t kDigits = 64;
  return text.size() == kDigits && text.find_first_not_of("0123456789abcdef") == text.npos;
}

// Names and digests of a candidate's files. Results written by the page or by other languages have
// none.
Result<CandidateFiles> read_files(const Json& candidate, const std::string& place) {
  CandidateFiles files;
  const auto read = [&](const char* key, const char* allowed, const auto& take) -> Result<void> {
    if (!candidate.is_object() || !candidate.contains(key)) return {};
    const Json& object = candidate[key];
    const std::string at = place + "." + key;
    if (!object.is_object()) return fail(ErrorCode::parse, say("must_be_object"), at);
    for (const auto& [format, text] : object.items()) {
      if (text.is_string() && take(format, text.template get<std::string>())) continue;
      return fail(ErrorCode::parse, say("must_be", allowed), at + "." + format.substr(0, 20));
    }
    return {};
  };
  const auto take_name = [&](const std::string& format, const std::string& name) {
    files[format].name = name;
    return is_plain_name(name);
  };
  const auto take_digest = [&](const std::string& format, const std::string& digits) {
    if (!files.contains(format)) return false;
    files[format].sha256 = digits;
    return is_sha256(digits);
  };
  SHG_TRY(read("files", "the name of a file beside this one", take_name));
  SHG_TRY(read("sha256", "64 hexadecimal digits, of a file", take_digest));
  return files;
}

// Frame rate (Hz) of a candidate's files; `rate` is kept if none is given.
Result<void> read_rate(const Json& candidate, const std::string& place, double& rate) {
  if (!candidate.contains("fps")) return {};
  const Json& fps = candidate["fps"];
  if (!fps.is_number()) return fail(ErrorCode::parse, say("must_be_a_number"), place);
  rate = fps.get<double>();
  return check_rate(rate, place);
}

// Motions of a candidate's actions, in their order.
Result<std::vector<WorkMotion>> read_motions(const ParameterList& list, const Json& candidate,
                                             std::size_t actions, const std::string& place) {
  constexpr std::size_t kMost = 4 * kActionsMax;
  constexpr std::uint64_t kMostWays = 100;
  std::vector<WorkMotion> motions;
  const auto all = candidate.find("motions");
  if (all == candidate.end() || !all->is_array() || all->size() > kMost) {
    return fail(ErrorCode::parse, say("must_be_list_of", "motions"), place + ".motions");
  }
  for (std::size_t k = 0; k < all->size(); ++k) {
    const std::string at = fmt::format("{}.motions[{}]", place, k);
    WorkMotion& motion = motions.emplace_back();
    std::size_t action = 0;
    JsonReader reader((*all)[k], at);
    reader.integer("action", action, 1, actions);
    reader.integer("way", motion.way, 0, kMostWays);
    reader.integer("approach", motion.approach, 0, kMostWays);
    reader.number("duration_s", motion.duration, kTaskDurationMin, 2.0 * kTaskDurationMax);
    for (const char* key : {"action", "duration_s"}) reader.require(key);
    if (!reader.has("parameters")) reader.wrong("parameters", say("is_missing"));
    if (const auto& error = reader.finish()) return tl::unexpected(*error);
    motion.action = action - 1;
    SHG_TRY_ASSIGN(motion.values, read_parameters(list, (*all)[k], at));
    if (k > 0 && motions[k - 1].action > motion.action) {
      return fail(ErrorCode::parse, say("must_be", "in the order of actions"), at);
    }
  }
  return motions;
}

Result<void> check_version(const Json& json, const std::string& place) {
  const auto version = json.find("version");
  if (version != json.end() && *version == kResultVersion) return {};
  return fail(ErrorCode::parse,
              say("version_is", version == json.end() ? "missing" : version->dump().substr(0, 60),
                  kResultVersion),
              place);
}

// Checks that a result holds its measured character, so that it can be edited without any other
// file.
Result<void> check_character(const CharacterSpec& character, const std::string& place) {
  if (is_complete(character)) return {};
  return fail(ErrorCode::parse,
              is_robot(character) ? say("urdf_missing") : say("landmarks_missing"), place);
}

Result<void> check_count(const Json& candidates, const std::string& place) {
  if (candidates.empty()) return fail(ErrorCode::parse, say("candidates_empty"), place);
  if (candidates.size() <= kResultMaxCandidates) return {};
  return fail(ErrorCode::parse, say("candidates_most", candidates.size(), kResultMaxCandidates),
              place);
}

}  // namespace

RunInfo search_info(const Task& task, std::chrono::steady_clock::time_point begin) {
  RunInfo info = replay_info(std::string(word_of(search_of(task))), begin);
  info.threads = thread_count(task.batch.threads);
  info.simd = simd_name(task.batch.simd);
  return info;
}

RunInfo replay_info(std::string how, std::chrono::steady_clock::time_point begin) {
  const auto elapsed = std::chrono::steady_clock::now() - begin;
  return {.elapsed_ms = std::chrono::duration<double, std::milli>(elapsed).count(),
          .search = std::move(how)};
}

TaskFile played_task(TaskFile file, const GenerateResult& generation) {
  if (generation.slowed || generation.gentled) file.duration = generation.duration;
  return file;
}

std::string format_result(const FinishedRun& finished, const ResultFiles& files) {
  FinishedRun run = finished;
  const Result<std::vector<MotionCost>> costs =
      run.costs.empty() ? candidate_costs(run) : std::vector<MotionCost>{};
  if (costs && !costs->empty()) run.costs = *costs;
  const auto& [file, task, generation, info, told] = run;
  Json json;
  json["version"] = kResultVersion;
  json["status"] = word_of(generation.status);
  json["remaining_mm"] = generation.remaining_distance * kMillimetres;
  if (generation.remaining_turn > 0.0) json["remaining_deg"] = degrees(generation.remaining_turn);
  json["seed"] = file.seed;
  json["evaluations"] = generation.log.evaluations;
  json["runs"] = generation.log.runs;
  json["elapsed_ms"] = info.elapsed_ms;
  if (traits_of(task.preset).layers == LayerStack::paper)
    json["cells_searched"] = generation.log.cells_searched;
  json["threads"] = info.threads;
  json["simd"] = info.simd;
  json["character"] = file.character.source;
  if (!files.character.empty()) json["character_file"] = files.character;
  json["preset"] = word_of(task.preset);
  json["search"] = info.search;
  json["goals"] = Json::array();
  for (const Goal& goal : task.goals) {
    json["goals"].push_back({{"effector", goal.effector}, {"position_m", to_json(goal.position)}});
  }
  json["candidates"] = Json::array();
  for (std::size_t i = 0; i < generation.candidates.size(); ++i) {
    json["candidates"].push_back(candidate_to_json(run, i, files));
  }
  if (!generation.fewer.empty()) {
    json["fewer"] = generation.fewer.text;
    json["fewer_message"] = message_to_json(generation.fewer);
  }
  if (!generation.conflict.empty()) {
    json["conflict"] = generation.conflict.text;
    json["conflict_message"] = message_to_json(generation.conflict);
  }
  if (const std::vector<Message> notes = goal_notes(task); !notes.empty()) {
    json["goal_notes"] = texts_to_json(notes);
    for (const Message& note : notes) json["goal_note_messages"].push_back(message_to_json(note));
  }
  if (!files.notes.empty()) json["file_notes"] = texts_to_json(files.notes);
  json["search_detail"] = search_to_json(generation);
  json["doubts"] = texts_to_json(task.doubts);
  json["task"] = task_to_json(played_task(file, generation));
  // names from files may hold any bytes; invalid UTF-8 is replaced
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<StoredResult> parse_result(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(const Json json, parse_json(text, name));
  const std::string place(name);
  if (!json.is_object() || !json.contains("task") || !json.contains("candidates") ||
      !json["candidates"].is_array()) {
    return fail(ErrorCode::parse, say("no_result"), place);
  }
  SHG_TRY(check_version(json, place));
  StoredResult result;
  SHG_TRY_ASSIGN(result.task, task_from_json(json["task"], place + ": task"));
  if (!result.task.scene.empty()) {
    return fail(ErrorCode::parse, say("scene_in_result"), place + ": task.scene");
  }
  if (json.contains("character_file") && json["character_file"].is_string()) {
    result.character = json["character_file"].get<std::string>();
  }
  SHG_TRY(check_character(result.task.character, place + ": task.character"));
  const Json& candidates = json["candidates"];
  SHG_TRY(check_count(candidates, place));
  SHG_TRY_ASSIGN(const PosedBody body, build_body(result.task));
  const Result<ParameterList> list = parameter_list(body, body.home, result.task);
  if (!list) return fail(ErrorCode::parse, list.error().to_message(), place + ": task");
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const std::string at = fmt::format("{}: candidates[{}]", place, i);
    SHG_TRY_ASSIGN(result.files.emplace_back(), read_files(candidates[i], at));
    SHG_TRY(read_rate(candidates[i], at + ".fps", result.rate));
    SHG_TRY_ASSIGN(result.candidates.emplace_back(), read_parameters(*list, candidates[i], at));
    if (result.task.actions.empty()) continue;
    SHG_TRY_ASSIGN(result.motions.emplace_back(),
                   read_motions(*list, candidates[i], result.task.actions.size(), at));
  }
  return result;
}

}  // namespace shigusa
