// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <shigusa/files.hpp>
#include <string>
#include <vector>

#include "mujoco_file.hpp"
#include "robot_tree.hpp"

namespace shigusa::bench {

// A character from a file.
struct CastMember {
  std::shared_ptr<const std::string> bytes;  // of the file
  std::filesystem::path folder;
  CharacterSpec character;         // measured, standing
  double stature = 0.0;            // m
  bool toes = false;               // its heels may lift
  std::optional<RobotTree> robot;  // by the file itself; of MJCF by the URDF that a result holds
  std::shared_ptr<const MujocoFile> mujoco{};  // the file loaded by MuJoCo, or null
};

// The person of the file measured on a seat (m).
[[nodiscard]] CharacterSpec seated_member(const CastMember& member, double seat);

// All characters of the tasks beside the built-in bodies.
struct Cast {
  std::vector<CastMember> people;
  std::vector<CastMember> robots;
  std::vector<std::string> absent;  // files that are refused, and why
};

// Files of this repository, and those of a folder if it exists.
[[nodiscard]] Cast load_cast(const std::filesystem::path& folder);

}  // namespace shigusa::bench
