// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/motion.hpp>

#include "core/index.hpp"
#include "human/landmark_points.hpp"

namespace shigusa {

// Fails on options that apply to persons only.
[[nodiscard]] Result<void> check_robot_options(const CharacterSpec& spec);

// Reads the robot of a URDF or MJCF file: sets urdf, humanoid and, for MJCF, doubts. Files that an
// MJCF file includes are read from `folder`; without a folder they are not found.
[[nodiscard]] Result<void> load_robot(std::string_view bytes, CharacterSpec& spec,
                                      const std::optional<std::filesystem::path>& folder);

// Body of a robot that was read, standing on settled feet.
[[nodiscard]] Result<PosedBody> build_robot_character(const CharacterSpec& spec);

// Lists the mapped bones with their node names, given by name_of(index).
inline void list_bones(const HumanoidMap& map, const auto& name_of, CharacterSpec& spec) {
  for (const HumanoidBone bone : kHumanoidBones) {
    if (map[bone] < 0) continue;
    spec.humanoid.emplace_back(humanoid_bone_name(bone), name_of(index(map[bone])));
  }
}

}  // namespace shigusa
