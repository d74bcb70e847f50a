// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate/generator.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// The kinds of editable numbers.
enum class EditableKind { weight, angle, share };

// One of the numbers that a person edits of a motion. "name=value" is an assignment (see
// assign_parameter); so is, of a weight, "joint.locked=true", with `joint` the name without
// ".weight".
struct EditableParameter {
  std::string name;                          // "right_knee.flexion.weight", "squat_deg", "bow"
  std::string group;                         // "right_leg", "left_arm", "trunk", "posture", "path"
  EditableKind kind = EditableKind::weight;  // what the number is
  double value = 0.0;                        // angles in degrees
  double low = 0.0;                          // what makes sense; of a posture more is allowed
  double high = 0.0;                         // the same
  bool locked = false;                       // of a weight: the freedom keeps its start angle
  std::string_view sentence{};               // what it does
};

// All of a candidate's, in the order of the body and the posture; of layered presets those of their
// layers.
[[nodiscard]] Result<std::vector<EditableParameter>> editable_parameters(
    const Task& task, const Candidate& candidate);

// The same as JSON text: a list of {"name", "group", "kind", "value", "low", "high", "scale"
// ("linear" or "log"), "unit" ("" or "deg"), "locked", "sentence"}.
[[nodiscard]] std::string format_parameters(const std::vector<EditableParameter>& parameters);

}  // namespace shigusa
