// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/files.hpp>

#include "field_json.hpp"

namespace shigusa {

// Readers of task fields that are more than a number, a text, a word or a point; field_json.hpp
// finds them by type. Errors are kept in the reader.

inline constexpr double kCriteriaRange = 1e6;  // weights and reference scales
inline constexpr double kCriteriaTiny = 1e-9;  // least reference scale, above 0

// Reads an axis, as three numbers or one word.
void read_composite(JsonReader& goal, const char* key, GoalAxis& axis);
// Reads a mixture of criteria by its name.
void read_mixture(JsonReader& holder, const char* key, CriteriaSettings& criteria);
// Reads a mixture by its name, or weights and reference scales; absent members keep their values.
void read_composite(JsonReader& task, const char* key, CriteriaSettings& criteria);
// Reads a habit by its name, or its numbers; absent ones keep their values.
void read_composite(JsonReader& task, const char* key, Habit& habit);
// Read what a motion does not tell; absent members keep their values.
void read_composite(JsonReader& task, const char* key, Ergonomics& ergonomics);
void read_composite(JsonReader& task, const char* key, PostureThresholds& thresholds);
// Reads things by their names.
void read_composite(JsonReader& task, const char* key, std::vector<Thing>& things);
// Reads a place on the floor, [x, z], with its facing and height.
void read_composite(JsonReader& action, const char* key, Stance& stance);
void read_composite(JsonReader& thing, const char* key, ThingHandle& handle);
void read_composite(JsonReader& character, const char* key, BoneRequest& map);
void read_composite(JsonReader& character, const char* key, std::optional<Landmarks>& person);
using Places = decltype(CharacterSpec::places);
void read_composite(JsonReader& character, const char* key, Places& places);

[[nodiscard]] Json composite_to_json(ToJson, const CriteriaSettings& criteria);
[[nodiscard]] Json composite_to_json(ToJson, const Habit& habit);
[[nodiscard]] Json composite_to_json(ToJson, const std::vector<Thing>& things);
[[nodiscard]] Json composite_to_json(ToJson, const Stance& stance);
[[nodiscard]] Json composite_to_json(ToJson, const BoneRequest& map);
[[nodiscard]] Json composite_to_json(ToJson, const Landmarks& person);
[[nodiscard]] Json composite_to_json(ToJson, const Places& places);

// Refuses a second goal for the same effector.
void end_item(JsonReader& goal, const std::vector<Goal>& goals);
// Gives an unnamed obstacle a default name, such as "obstacle 2".
void begin_item(std::vector<Obstacle>& obstacles);

}  // namespace shigusa
