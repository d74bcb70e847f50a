// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>
#include <string_view>

#include "files/json_memory.hpp"

namespace shigusa {

using GltfJson = nlohmann::json;

// Parses a glTF, GLB or VRM file, keeping only the members that describe its skeleton:
// asset.version; name, children, mesh, skin, transform and some extras of nodes; joints and inverse
// bind matrices of skins; the humanoid bones of VRM. The size is bounded, but values may still be
// of any kind. Errors name the file.
[[nodiscard]] Result<GltfJson> read_gltf_json(std::string_view bytes, std::string_view name);

// Whether a value is that text. Unlike `==`, it takes no memory, so it may be used where nothing
// may throw.
[[nodiscard]] inline bool is_text(const GltfJson& value, std::string_view text) {
  const auto* const own = value.get_ptr<const std::string*>();
  return own != nullptr && *own == text;
}

// A value for a message: short, and ASCII only.
[[nodiscard]] std::string json_shown(const GltfJson& value, std::size_t longest = 60);

}  // namespace shigusa
