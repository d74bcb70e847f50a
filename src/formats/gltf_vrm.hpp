// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>
#include <utility>
#include <vector>

#include "files/json_memory.hpp"
#include "formats/gltf.hpp"

namespace shigusa {

// The bones of a file's VRM extension, in terms of the file's own nodes.
struct VrmBones {
  VrmVersion version = VrmVersion::none;
  HumanoidMap map;
  // all bones by the file's name and node, fingers and eyes among them
  std::vector<std::pair<std::string, int>> all;
  std::vector<Message> doubts;
};

// Reads the bones of VRM 0.x and 1.0; `nodes`: how many the file has. A file may hold both, then
// 1.0 is read. Never fails: what is no bone or no node of the file is left out, with a doubt.
[[nodiscard]] VrmBones read_vrm_bones(const nlohmann::json& file, int nodes);

}  // namespace shigusa
