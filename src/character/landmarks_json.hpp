// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/human.hpp>

#include "formats/json_reader.hpp"
#include "human/landmark_points.hpp"

namespace shigusa {

[[nodiscard]] Json landmarks_to_json(const Landmarks& person);

// The JSON schema of that object, which refers to the schemas `point`, `sole` and `part`, and those
// two of them.
[[nodiscard]] Json landmarks_schema();
[[nodiscard]] Json sole_schema();
[[nodiscard]] Json part_schema();

// The object `landmarks_m` of a character, where it has one. Wrong are points far away, joints of a
// limb that coincide, soles that are none and shapes without a thickness.
[[nodiscard]] std::optional<Landmarks> read_landmarks(JsonReader& character);

}  // namespace shigusa
