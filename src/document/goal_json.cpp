// SPDX-License-Identifier: MIT
#include "goal_json.hpp"

#include <shigusa/body/load.hpp>
#include <shigusa/character/axis_words.hpp>
#include <utility>

namespace shigusa {
namespace {

constexpr std::size_t kGoalsMax = 64;  // more than any body can meet

// Three numbers, or a word that stands for them.
template <class Named>
void read_axis(JsonReader& reader, const char* key, Vec3d& into, Named&& named) {
  reader.require(key);
  if (!reader.has(key) || !reader.value(key).is_string()) {
    return reader.vector(key, into, kGoalRange);
  }
  const Result<Vec3d> vector = named(reader.value(key).get<std::string>());
  if (!vector) return reader.wrong(key, vector.error().to_string());
  into = *vector;
}

void read_turn(JsonReader& goal, Goal& into) {
  if (goal.has("rotation_xyzw")) goal.quaternion("rotation_xyzw", into.rotation.emplace());
  if (!goal.has("axis")) return;
  if (into.rotation)
    return goal.wrong("axis", "stands beside rotation_xyzw; allowed is one of both");
  JsonReader reader = goal.object("axis");
  GoalAxis& axis = into.axis.emplace();
  read_axis(reader, "axis", axis.axis,
            [&](const std::string& word) { return hand_axis(word, into.effector); });
  read_axis(reader, "direction", axis.direction,
            [](const std::string& word) { return direction_named(word); });
  goal.absorb(reader.finish());
}

}  // namespace

Json goal_to_json(const Goal& goal) {
  Json json{{"effector", goal.effector}, {"position_m", to_json(goal.position)}};
  if (goal.load > 0.0) json["load_kg"] = goal.load;
  if (goal.rotation) json["rotation_xyzw"] = to_json(*goal.rotation);
  if (goal.axis) {
    json["axis"] = {{"axis", to_json(goal.axis->axis)},
                    {"direction", to_json(goal.axis->direction)}};
  }
  if (goal.tolerance != Vec3d{}) json["tolerance_m"] = to_json(goal.tolerance);
  return json;
}

void read_goals(JsonReader& task, std::vector<Goal>& goals) {
  if (!task.has("goals")) return;
  const Json& list = task.value("goals");
  if (!list.is_array()) return task.wrong("goals", "must be a list [ … ] of goals");
  if (list.size() > kGoalsMax) {
    return task.wrong("goals", "are " + std::to_string(list.size()) + "; allowed are " +
                                   std::to_string(kGoalsMax) + " at most");
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    JsonReader reader(list[i], task.place_of("goals[" + std::to_string(i) + "]"));
    Goal goal;
    reader.require("effector");
    reader.text("effector", goal.effector);
    reader.require("position_m");
    reader.vector("position_m", goal.position, kGoalRange);
    std::optional<double> load;
    reader.number("load_kg", load, 0.0, kLoadMax);
    goal.load = load.value_or(0.0);
    read_turn(reader, goal);
    reader.vector("tolerance_m", goal.tolerance, 0.0, kToleranceMax);
    for (const Goal& earlier : goals) {
      if (earlier.effector != goal.effector) continue;
      reader.wrong("effector", "is a second goal for '" + goal.effector.substr(0, 80) +
                                   "'; allowed is one for each effector");
    }
    task.absorb(reader.finish());
    goals.push_back(std::move(goal));
  }
}

}  // namespace shigusa
