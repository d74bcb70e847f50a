// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>

#include "formats/json_reader.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// (nodes) m, world: where the rig's nodes are in the body's start posture.
[[nodiscard]] std::vector<Vec3d> start_places(const BodyModel& body, const Rig& rig);

// Finds the places of a measured person's spec, from its rig and the body that it is.
void find_places(const BodyModel& body, CharacterSpec& spec);

// The body with the spec's places.
[[nodiscard]] BodyModel placed_body(const CharacterSpec& spec, const BodyModel& body);

// The object `places_m` of a character that has one.
void read_places(JsonReader& character, std::vector<std::pair<std::string, Vec3d>>& places);

}  // namespace shigusa
