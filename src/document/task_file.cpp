// SPDX-License-Identifier: MIT
#include <array>
#include <shigusa/document/task_file.hpp>
#include <shigusa/io/file.hpp>
#include <shigusa/layers/assignment.hpp>

#include "character/character_places.hpp"
#include "character/humanoid_request.hpp"
#include "character/landmarks_json.hpp"
#include "goal_json.hpp"
#include "task_json.hpp"

namespace shigusa {
namespace {

constexpr double kCriteriaRange = 1e6;  // weights and reference scales
constexpr double kCriteriaTiny = 1e-9;  // reference scales are above 0
constexpr std::uint64_t kFrameMax = 1'000'000;
constexpr std::uint64_t kCandidatesMax = 1000;
constexpr std::uint64_t kEvaluationsMax = 1'000'000'000;

constexpr std::array<std::pair<const char*, BodyExtent>, 3> kExtents{
    {{"half", BodyExtent::half}, {"full", BodyExtent::full}, {"human", BodyExtent::human}}};

Json character_to_json(const CharacterSpec& c) {
  Json json;
  json["source"] = c.source;
  if (c.stature) json["stature_m"] = *c.stature;
  if (c.mass) json["mass_kg"] = *c.mass;
  for (const auto& [bone, node] : c.map) json["map"][bone] = node;
  if (c.urdf) {
    json["urdf"] = *c.urdf;
    if (!c.doubts.empty()) json["doubts"] = c.doubts;
    return json;
  }
  json["sex"] = c.sex == Sex::male ? "male" : "female";
  if (c.seat) json["seat_m"] = *c.seat;
  if (c.heels) json["heels"] = true;
  if (is_built_in(c)) return json;
  for (const auto& [name, extent] : kExtents) {
    if (c.extent == extent) json["extent"] = name;
  }
  if (c.frame) json["frame"] = *c.frame == kRestPose ? Json("rest") : Json(*c.frame);
  if (c.animation) json["animation"] = *c.animation;
  if (!c.doubts.empty()) json["doubts"] = c.doubts;
  add_places(c, json);
  if (c.landmarks) json["landmarks_m"] = landmarks_to_json(*c.landmarks);
  return json;
}

void read_truth(JsonReader& reader, const char* key, bool& into) {
  if (!reader.has(key)) return;
  if (!reader.value(key).is_boolean()) return reader.wrong(key, "must be true or false");
  into = reader.value(key).get<bool>();
}

void read_texts(JsonReader& reader, const char* key, std::vector<std::string>& texts) {
  if (!reader.has(key)) return;
  const Json& list = reader.value(key);
  if (!list.is_array()) return reader.wrong(key, "must be a list of texts");
  for (const Json& text : list) {
    if (!text.is_string()) return reader.wrong(key, "must be a list of texts");
    texts.push_back(text.get<std::string>());
  }
}

void read_frame(JsonReader& reader, std::optional<int>& frame) {
  if (!reader.has("frame")) return;
  if (reader.value("frame") == "rest") {
    frame = kRestPose;
  } else if (reader.value("frame").is_string()) {
    reader.wrong("frame", R"(must be a whole number from 0, or "rest")");
  } else {
    reader.integer("frame", frame.emplace(), 0, kFrameMax);
  }
}

// The freedoms of a person from a file where nothing is said: all, but the published method and its
// layers are of bodies like the paper's.
BodyExtent usual_extent(Preset preset) {
  return traits_of(preset).natural ? BodyExtent::human : BodyExtent::full;
}

void check_character(JsonReader& reader, const CharacterSpec& c) {
  if (const auto known = check_source(c); !known) reader.wrong("source", known.error().message);
  if (c.urdf && c.landmarks) reader.wrong("urdf", "is of a robot, and landmarks_m of a person");
  for (const char* key :
       {"extent", "frame", "animation", "map", "doubts", "landmarks_m", "places_m", "urdf"}) {
    if (!reader.has(key) || !is_built_in(c)) continue;
    reader.wrong(key,
                 "is of a character from a file, and " + c.source + " is built in: leave it out");
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
  reader.require("source");
  reader.text("source", c.source);
  reader.number("stature_m", c.stature, 0.5, 2.5);
  reader.number("mass_kg", c.mass, 2.0, 300.0);
  reader.choice<Sex>("sex", c.sex, {{"male", Sex::male}, {"female", Sex::female}});
  if (reader.has("extent")) {
    reader.choice<BodyExtent>("extent", c.extent.emplace(), {kExtents.begin(), kExtents.end()});
  }
  read_frame(reader, c.frame);
  reader.number("seat_m", c.seat, 0.1, 1.2);
  read_truth(reader, "heels", c.heels);
  if (reader.has("animation")) reader.text("animation", c.animation.emplace());
  read_texts(reader, "doubts", c.doubts);
  if (reader.has("urdf")) reader.text("urdf", c.urdf.emplace());
  if (reader.has("map")) {
    if (Result<BoneRequest> map = bone_request(reader.value("map")); map) {
      c.map = std::move(*map);
    } else {
      reader.wrong("map", map.error().message);
    }
  }
  c.landmarks = read_landmarks(reader);
  if (c.landmarks) read_places(reader, c);
  check_character(reader, c);
  task.absorb(reader.finish());
}

void read_obstacles(JsonReader& task, std::vector<Obstacle>& obstacles) {
  if (!task.has("obstacles")) return;
  const Json& list = task.value("obstacles");
  if (!list.is_array() || list.size() > kObstaclesMax) {
    return task.wrong("obstacles",
                      fmt::format("must be a list of at most {} obstacles", kObstaclesMax));
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    JsonReader reader(list[i], task.place_of("obstacles[" + std::to_string(i) + "]"));
    Obstacle& obstacle = obstacles.emplace_back();
    obstacle.name = fmt::format("obstacle {}", i + 1);
    reader.text("name", obstacle.name);
    reader.require("position_m");
    reader.vector("position_m", obstacle.position, kGoalRange);
    reader.vector("size_m", obstacle.size, 0.0, kGoalRange);
    std::optional<double> radius;
    reader.number("radius_m", radius, 0.0, kGoalRange);
    obstacle.radius = radius.value_or(0.0);
    reader.quaternion("rotation_xyzw", obstacle.rotation);
    task.absorb(reader.finish());
  }
}

Json obstacle_to_json(const Obstacle& obstacle) {
  const Quatd& q = obstacle.rotation;
  return {{"name", obstacle.name},
          {"position_m", to_json(obstacle.position)},
          {"size_m", to_json(obstacle.size)},
          {"radius_m", obstacle.radius},
          {"rotation_xyzw", to_json(q)}};
}

// A mixture by its name, or weights and reference scales; what is not given stays as it is.
void read_criteria(JsonReader& task, CriteriaSettings& criteria) {
  if (!task.has("criteria")) return;
  if (task.value("criteria").is_string()) {
    std::vector<std::pair<std::string, CriteriaSettings>> presets;
    for (const CriteriaPreset& preset : criteria_presets()) {
      presets.emplace_back(preset.name, preset.settings());
    }
    return task.choice("criteria", criteria, presets);
  }
  JsonReader reader = task.object("criteria");
  double sum = 0.0;
  for_each_criterion([&](const auto& criterion) {
    if (reader.has(criterion.name)) {
      JsonReader members = reader.object(criterion.name);
      members.number("weight", criterion.weight(criteria), 0.0, kCriteriaRange);
      members.number(criterion.scale_name, criterion.scale(criteria), kCriteriaTiny,
                     kCriteriaRange);
      reader.absorb(members.finish());
    }
    sum += criterion.weight(criteria);
  });
  if (sum <= 0.0) {
    reader.wrong("", "all weights are 0; allowed are weights of which one or more is above 0");
  }
  task.absorb(reader.finish());
}

}  // namespace

Json task_to_json(const TaskFile& task) {
  Json json;
  json["version"] = kTaskVersion;
  json["character"] = character_to_json(task.character);
  json["goals"] = Json::array();
  for (const Goal& goal : task.goals) {
    json["goals"].push_back(goal_to_json(goal));
  }
  if (task.look_at) json["look_at_m"] = to_json(*task.look_at);
  if (task.contacts) json["contacts"] = *task.contacts;
  for (const Obstacle& obstacle : task.obstacles) {
    json["obstacles"].push_back(obstacle_to_json(obstacle));
  }
  if (task.duration) json["duration_s"] = *task.duration;
  json["preset"] = word_of(task.preset);
  if (traits_of(task.preset).layers || task.layer_reading != LayerReading{}) {
    json["layer_reading"] = word_of(task.layer_reading);
  }
  if (task.search) json["search"] = word_of(*task.search);
  for_each_criterion([&](const auto& criterion) {
    json["criteria"][criterion.name] = {{"weight", criterion.weight(task.criteria)},
                                        {criterion.scale_name, criterion.scale(task.criteria)}};
  });
  if (!task.fixed.empty()) json["fixed"] = task.fixed;
  if (task.pareto) json["pareto"] = true;
  if (task.generator != MotionGenerator{}) json["generator"] = word_of(task.generator);
  if (task.phases != 1) json["phases"] = task.phases;
  json["seed"] = task.seed;
  json["candidates"] = task.candidates;
  if (task.evaluations) json["evaluations"] = *task.evaluations;
  return json;
}

Result<TaskFile> task_from_json(const Json& json, const std::string& place) {
  JsonReader reader(json, place + ": ");
  TaskFile task;
  int version = kTaskVersion;
  reader.integer("version", version, kTaskVersion, kTaskVersion);
  read_character(reader, task.character);
  read_goals(reader, task.goals);
  read_obstacles(reader, task.obstacles);
  if (reader.has("look_at_m")) reader.vector("look_at_m", task.look_at.emplace(), kGoalRange);
  if (reader.has("contacts")) read_texts(reader, "contacts", task.contacts.emplace());
  reader.number("duration_s", task.duration, kTaskDurationMin, kTaskDurationMax);
  reader.word("preset", task.preset);
  reader.word("layer_reading", task.layer_reading);
  task.criteria = traits_of(task.preset).criteria();
  task.candidates = traits_of(task.preset).candidates;
  if (reader.has("search")) reader.word("search", task.search.emplace());
  read_truth(reader, "pareto", task.pareto);
  if (task.pareto) task.criteria = pareto_criteria();
  read_criteria(reader, task.criteria);
  reader.word("generator", task.generator);
  reader.integer("phases", task.phases, 1, kPhasesMax);
  read_texts(reader, "fixed", task.fixed);
  reader.integer("seed", task.seed, 0, UINT64_MAX);
  reader.integer("candidates", task.candidates, 1, kCandidatesMax);
  if (reader.has("evaluations")) {
    int evaluations = 1;
    reader.integer("evaluations", evaluations, kPaperPopulation, kEvaluationsMax);
    task.evaluations = evaluations;
  }
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return task;
}

Result<CharacterSpec> parse_character_spec(std::string_view text, std::string_view name) {
  Result<Json> json = parse_json(text, name);
  if (!json) return tl::unexpected(json.error());
  const Json holder{{"character", std::move(*json)}};
  JsonReader reader(holder, std::string(name) + ": ");
  CharacterSpec spec;
  read_character(reader, spec);
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return spec;
}

Result<TaskFile> parse_task(std::string_view text, std::string_view name) {
  const Result<Json> json = parse_json(text, name);
  if (!json) return tl::unexpected(json.error());
  return task_from_json(*json, std::string(name));
}

Result<TaskFile> read_task(const std::filesystem::path& path) {
  const Result<std::string> text = read_text_file(path, kTaskMaxBytes);
  if (!text) return tl::unexpected(text.error());
  return parse_task(*text, path.filename().string());
}

std::string format_task(const TaskFile& task) {
  // a file's name may hold anything; what is not UTF-8 is replaced
  return task_to_json(task).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<BodyModel> build_body(const TaskFile& file) {
  constexpr std::array<std::string_view, 3> kRightFoot{"right_foot", "right_ankle", "right_toes"};
  const auto is_right_foot = [&](const std::string& name) {
    return std::find(kRightFoot.begin(), kRightFoot.end(), name) != kRightFoot.end();
  };
  const bool kept =
      !file.contacts || std::any_of(file.contacts->begin(), file.contacts->end(), is_right_foot);
  const bool moved = std::any_of(file.goals.begin(), file.goals.end(),
                                 [&](const Goal& goal) { return is_right_foot(goal.effector); });
  const bool on_both = file.contacts && file.contacts->size() > 1;
  return build_character(file.character, kept && !moved ? Side::right : Side::left, on_both);
}

Result<Task> make_task(TaskFile& file, const std::filesystem::path& folder) {
  if (const auto measured = measure_character(file.character, folder); !measured) {
    return tl::unexpected(measured.error());
  }
  if (file.character.landmarks && !file.character.extent) {
    file.character.extent = usual_extent(file.preset);
  }
  Result<BodyModel> body = build_body(file);
  if (!body) return tl::unexpected(body.error());
  Task task{.body = std::move(*body),
            .goals = file.goals,
            .duration = file.duration,
            .preset = file.preset,
            .criteria = file.criteria,
            .search = file.search,
            .seed = file.seed,
            .candidates = file.candidates,
            .evaluations = file.evaluations};
  task.obstacles = file.obstacles;
  task.look_at = file.look_at;
  task.contacts = file.contacts;
  task.pareto = file.pareto;
  task.generator = file.generator;
  task.phases = file.phases;
  const Plan plan = whole_body_plan(task.body);
  for (const std::string& assignment : file.fixed) {
    if (!task.fixed) task.fixed = no_fixed_parameters(task.body);
    if (const auto done = fix_parameter(plan, assignment, *task.fixed); !done) {
      return fail(done.error().code, done.error().message,
                  "fixed parameter " + assignment.substr(0, 80));
    }
  }
  task.layers.reading = file.layer_reading;
  return task;
}

}  // namespace shigusa
