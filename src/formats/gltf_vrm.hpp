// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>
#include <utility>
#include <vector>

#include "files/json_memory.hpp"
#include "formats/gltf.hpp"

namespace shigusa {

// Bones of a file's VRM extension as nodes of the file.
struct VrmBones {
  VrmVersion version = VrmVersion::none;
  HumanoidMap map;
  // all bones by the file's names, fingers and eyes included
  std::vector<std::pair<std::string, int>> all;
  std::vector<Message> doubts;
};

// Reads the bones of VRM 0.x and 1.0; `nodes`: number of nodes in the file. If a file holds both,
// 1.0 is read. Never fails: unknown bones and missing nodes are left out, with a doubt.
[[nodiscard]] VrmBones read_vrm_bones(const nlohmann::json& file, int nodes);

}  // namespace shigusa
