// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>

#include "formats/json_reader.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// (nodes) m, world: positions of the rig's nodes with the body at home.
[[nodiscard]] std::vector<Vec3d> start_places(const PosedBody& body, const Rig& rig);

// Computes `places` of a measured person's spec, from its rig and its body.
void find_places(const PosedBody& body, CharacterSpec& spec);

// The body with the spec's places.
[[nodiscard]] PosedBody placed_body(const CharacterSpec& spec, PosedBody body);

// Reads the optional object `places_m` of a character.
void read_places(JsonReader& character, std::vector<std::pair<std::string, Vec3d>>& places);

}  // namespace shigusa
