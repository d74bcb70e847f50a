// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/human.hpp>

#include "formats/json_reader.hpp"
#include "human/landmark_points.hpp"

namespace shigusa {

[[nodiscard]] Json landmarks_to_json(const Landmarks& person);

// JSON schema of the object `landmarks_m`, which refers to the schemas `point`, `sole` and `part`,
// and the latter two schemas.
[[nodiscard]] Json landmarks_schema();
[[nodiscard]] Json sole_schema();
[[nodiscard]] Json part_schema();

// Reads the optional object `landmarks_m` of a character. Errors are far points, coinciding joints
// of a limb, malformed soles and shapes without a thickness.
[[nodiscard]] std::optional<Landmarks> read_landmarks(JsonReader& character);

}  // namespace shigusa
