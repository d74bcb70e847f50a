// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <shigusa/result.hpp>
#include <string>
#include <string_view>

namespace shigusa {

using GltfJson = nlohmann::json;

// Of a glTF, GLB or VRM file what tells of its skeleton, everything else left out: asset.version;
// of nodes name, children, mesh, skin and place; of skins the joints and where their bind poses
// are; of VRM the humanoid bones. Its size is bounded, but each value may still be of any kind.
// Errors name the file.
[[nodiscard]] Result<GltfJson> read_gltf_json(std::string_view bytes, std::string_view name);

// A value as it stands in a message: short, and ASCII only.
[[nodiscard]] std::string shown(const GltfJson& value, std::size_t longest = 60);

}  // namespace shigusa
