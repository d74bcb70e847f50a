// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/motion.hpp>

#include "core/index.hpp"
#include "human/landmark_points.hpp"

namespace shigusa {

// Fails on what is of a person alone.
[[nodiscard]] Result<void> check_robot_options(const CharacterSpec& spec);

// Reads the robot of a URDF or MJCF file: fills urdf, humanoid and of MJCF doubts. Files that an
// MJCF file includes are looked for in `folder`; nowhere without one.
[[nodiscard]] Result<void> load_robot(std::string_view bytes, CharacterSpec& spec,
                                      const std::optional<std::filesystem::path>& folder);

// The body of a robot that was read, on settled feet.
[[nodiscard]] Result<BodyModel> build_robot_character(const CharacterSpec& spec);

// Tells the mapped bones by the names of their nodes, which name_of(index) gives.
inline void list_bones(const HumanoidMap& map, const auto& name_of, CharacterSpec& spec) {
  for (const HumanoidBone bone : kHumanoidBones) {
    if (map[bone] < 0) continue;
    spec.humanoid.emplace_back(humanoid_bone_name(bone), name_of(index(map[bone])));
  }
}

}  // namespace shigusa
