// SPDX-License-Identifier: MIT
#include "task_values.hpp"

#include <algorithm>
#include <shigusa/goal.hpp>
#include <utility>

#include "character/character_places.hpp"
#include "character/humanoid_request.hpp"
#include "character/landmarks_json.hpp"
#include "core/say.hpp"
#include "criteria/built_in_criteria.hpp"
#include "problem/thing_parts.hpp"

namespace shigusa {
namespace {

// Whether a thing may have the name: it is part of columns' and nodes' names.
bool is_thing_name(const std::string& name) {
  constexpr std::size_t kLongest = 64;
  return !name.empty() && name.size() <= kLongest &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '_' || c == '-';
         });
}

// Reads three numbers, or a word that stands for them.
template <class Named>
void read_axis(JsonReader& reader, const char* key, Vec3d& into, Named&& named) {
  reader.require(key);
  if (!reader.has(key) || !reader.value(key).is_string()) {
    return reader.vector(key, into, kGoalRange);
  }
  const Result<Vec3d> vector = named(reader.value(key).get<std::string>());
  if (!vector) return reader.wrong(key, vector.error().to_message());
  into = *vector;
}

}  // namespace

void read_composite(JsonReader& goal, const char* key, GoalAxis& axis) {
  if (goal.has("rotation_xyzw")) {
    return goal.wrong(key, say("beside_rotation"));
  }
  std::string effector;
  goal.text("effector", effector);
  JsonReader reader = goal.object(key);
  read_axis(reader, "axis", axis.axis,
            [&](const std::string& word) { return hand_axis(word, effector); });
  read_axis(reader, "direction", axis.direction,
            [&](const std::string& word) { return direction_named(word, effector); });
  goal.absorb(reader.finish());
}

void read_mixture(JsonReader& holder, const char* key, CriteriaSettings& criteria) {
  std::vector<std::pair<std::string, CriteriaSettings>> presets;
  for (const CriteriaPreset& preset : criteria_presets()) {
    presets.emplace_back(preset.name, preset.settings());
  }
  holder.choice(key, criteria, presets);
}

void read_composite(JsonReader& task, const char* key, CriteriaSettings& criteria) {
  if (task.value(key).is_string()) return read_mixture(task, key, criteria);
  JsonReader reader = task.object(key);
  double sum = 0.0;
  for (const CriterionTraits& criterion : kCriteria) {
    CriterionSetting& setting = criteria[criterion.kind];
    const std::string name(criterion.word);
    if (reader.has(name.c_str())) {
      JsonReader members = reader.object(name.c_str());
      members.number("weight", setting.weight, 0.0, kCriteriaRange);
      members.number(std::string(criterion.scale_name).c_str(), setting.scale, kCriteriaTiny,
                     kCriteriaRange);
      reader.absorb(members.finish());
    }
    sum += setting.weight;
  }
  if (sum <= 0.0) {
    reader.wrong("", say("all_weights_zero"));
  }
  task.absorb(reader.finish());
}

void read_composite(JsonReader& task, const char* key, Habit& habit) {
  if (task.value(key).is_string()) {
    std::vector<std::pair<std::string, Habit>> known;
    for (const NamedHabit& named : kHabits) known.emplace_back(named.word, named.habit);
    return task.choice(key, habit, known);
  }
  JsonReader reader = task.object(key);
  read_fields(reader, habit);
  task.absorb(reader.finish());
}

void read_composite(JsonReader& task, const char* key, Ergonomics& ergonomics) {
  JsonReader reader = task.object(key);
  read_fields(reader, ergonomics);
  task.absorb(reader.finish());
}

void read_composite(JsonReader& task, const char* key, PostureThresholds& thresholds) {
  JsonReader reader = task.object(key);
  read_fields(reader, thresholds);
  task.absorb(reader.finish());
}

void read_composite(JsonReader& task, const char* key, std::vector<Thing>& things) {
  const Json& all = task.value(key);
  if (!all.is_object()) return task.wrong(key, say("must_be_object"));
  if (all.size() > kThingsMax) return task.wrong(key, say("at_most", all.size(), kThingsMax));
  for (const auto& [name, thing] : all.items()) {
    if (!is_thing_name(name)) return task.wrong(key, say("thing_name", name.substr(0, 80)));
    JsonReader reader(thing, task.place_of(fmt::format("{}.{}", key, name)));
    read_fields(reader, things.emplace_back());
    things.back().name = name;
    if (!reader.has("centre_of_mass_m")) things.back().centre = centre_of(things.back().parts);
    task.absorb(reader.finish());
  }
}

void read_composite(JsonReader& action, const char* key, Stance& stance) {
  JsonReader reader = action.object(key);
  if (reader.has("position_m")) {
    const Json& place = reader.value("position_m");
    const auto is_fine = [](const Json& number) {
      return number.is_number() && abs(number.get<double>()) <= kGoalRange;
    };
    if (!place.is_array() || place.size() != 2 || !std::all_of(place.begin(), place.end(), is_fine))
      return action.wrong(key, say("floor_place", Metres{kGoalRange}));
    stance.x = place[0].get<double>();
    stance.z = place[1].get<double>();
  }
  read_fields(reader, stance);
  action.absorb(reader.finish());
}

void read_composite(JsonReader& thing, const char* key, ThingHandle& handle) {
  JsonReader reader = thing.object(key);
  read_fields(reader, handle);
  if (norm(handle.along) < kBarLeast) reader.wrong("along", say("bar_direction"));
  thing.absorb(reader.finish());
}

void read_composite(JsonReader& character, const char* key, BoneRequest& map) {
  Result<BoneRequest> read = bone_request(character.value(key));
  if (!read) return character.wrong(key, read.error().message);
  map = std::move(*read);
}

void read_composite(JsonReader& character, const char*, std::optional<Landmarks>& person) {
  person = read_landmarks(character);
}

void read_composite(JsonReader& character, const char* key, Places& places) {
  if (!character.has("landmarks_m")) {
    return character.wrong(key, say("of_landmarks"));
  }
  read_places(character, places);
}

Json composite_to_json(ToJson, const CriteriaSettings& criteria) {
  Json json;
  for (const CriterionTraits& criterion : kCriteria) {
    const CriterionSetting& setting = criteria[criterion.kind];
    json[std::string(criterion.word)] = {{"weight", setting.weight},
                                         {std::string(criterion.scale_name), setting.scale}};
  }
  return json;
}

Json composite_to_json(ToJson, const Habit& habit) {
  for (const NamedHabit& named : kHabits) {
    if (named.habit == habit) return named.word;
  }
  return fields_to_json(habit);
}

Json composite_to_json(ToJson, const std::vector<Thing>& things) {
  Json json = Json::object();
  for (const Thing& thing : things) json[thing.name] = fields_to_json(thing);
  return json;
}

Json composite_to_json(ToJson, const Stance& stance) {
  Json json = fields_to_json(stance);
  json["position_m"] = {stance.x, stance.z};
  return json;
}

Json composite_to_json(ToJson, const BoneRequest& map) {
  Json json;
  for (const auto& [bone, node] : map) json[bone] = node;
  return json;
}

Json composite_to_json(ToJson, const Landmarks& person) { return landmarks_to_json(person); }

Json composite_to_json(ToJson, const Places& places) {
  Json json;
  for (const auto& [node, at] : places) json[node] = to_json(at);
  return json;
}

void end_item(JsonReader& goal, const std::vector<Goal>& goals) {
  const std::string& effector = goals.back().effector;
  const auto same = [&](const Goal& earlier) { return earlier.effector == effector; };
  if (std::none_of(goals.begin(), goals.end() - 1, same)) return;
  goal.wrong("effector", say("second_goal", effector.substr(0, 80)));
}

void begin_item(std::vector<Obstacle>& obstacles) {
  obstacles.back().name = fmt::format("obstacle {}", obstacles.size());
}

}  // namespace shigusa
