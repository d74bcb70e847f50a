// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/files.hpp>

#include "field_json.hpp"

namespace shigusa {

// Values of a task's fields that are more than a number, a text, a word or a point; field_json.hpp
// finds these by their types. The reader keeps what is wrong.

inline constexpr double kCriteriaRange = 1e6;  // weights and reference scales
inline constexpr double kCriteriaTiny = 1e-9;  // reference scales are above 0

// Three numbers or a word each.
void read_composite(JsonReader& goal, const char* key, GoalAxis& axis);
// A mixture by its name.
void read_mixture(JsonReader& holder, const char* key, CriteriaSettings& criteria);
// A mixture by its name, or weights and reference scales; what is not given stays as it is.
void read_composite(JsonReader& task, const char* key, CriteriaSettings& criteria);
void read_composite(JsonReader& character, const char* key, BoneRequest& map);
void read_composite(JsonReader& character, const char* key, std::optional<Landmarks>& person);
using Places = decltype(CharacterSpec::places);
void read_composite(JsonReader& character, const char* key, Places& places);

[[nodiscard]] Json composite_to_json(ToJson, const CriteriaSettings& criteria);
[[nodiscard]] Json composite_to_json(ToJson, const BoneRequest& map);
[[nodiscard]] Json composite_to_json(ToJson, const Landmarks& person);
[[nodiscard]] Json composite_to_json(ToJson, const Places& places);

// A second goal for an effector is wrong.
void end_item(JsonReader& goal, const std::vector<Goal>& goals);
// An obstacle without a name is "obstacle 2".
void begin_item(std::vector<Obstacle>& obstacles);

}  // namespace shigusa
