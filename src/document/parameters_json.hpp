// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/layers/layered_parameters.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/json_reader.hpp"

namespace shigusa {

// The object of a candidate that holds its parameters.
[[nodiscard]] Result<const Json*> parameters_of(const Json& candidate, const std::string& place);

// Freedoms by name, each of which must have its weight; some may be locked.
using NamedJoints = std::vector<std::pair<std::string, JointWeight*>>;
void read_joints(JsonReader& reader, const NamedJoints& joints);

// Layered parameters as results hold them, and back; `layers` are those to the goals. Freedoms and
// contractions of the upper layer stand where other presets have theirs; what the layers below move
// an arm by stands under its name.
[[nodiscard]] Json layered_to_json(std::span<const Layer> layers, LayeredParameters parameters);
[[nodiscard]] Result<LayeredParameters> read_layered(std::span<const Layer> layers,
                                                     const Json& candidate,
                                                     const std::string& place);

}  // namespace shigusa
