// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>
#include <string_view>

#include "files/json_memory.hpp"

namespace shigusa {

using GltfJson = nlohmann::json;

// Of a glTF, GLB or VRM file what tells of its skeleton, everything else left out: asset.version;
// of nodes name, children, mesh, skin and place; of skins the joints and where their bind poses
// are; of VRM the humanoid bones. Its size is bounded, but each value may still be of any kind.
// Errors name the file.
[[nodiscard]] Result<GltfJson> read_gltf_json(std::string_view bytes, std::string_view name);

// Whether a value is that text. Compared with `==` a value would be made of the text, which takes
// memory where nothing may be thrown.
[[nodiscard]] inline bool is_text(const GltfJson& value, std::string_view text) {
  const auto* const own = value.get_ptr<const std::string*>();
  return own != nullptr && *own == text;
}

// A value as it stands in a message: short, and ASCII only.
[[nodiscard]] std::string json_shown(const GltfJson& value, std::size_t longest = 60);

}  // namespace shigusa
