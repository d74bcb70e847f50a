// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <span>
#include <string>
#include <string_view>

namespace shigusa {

// Member of a node's extras that marks nodes added by add_nodes: they belong to the skeleton
// although no skin binds them.
inline constexpr std::string_view kAddedNode = "shigusa_added";

// Members of a node's extras that describe a thing of a scene.
inline constexpr std::string_view kMassExtra = "mass_kg";
inline constexpr std::string_view kUprightExtra = "upright";

// A node to add below one of a glTF file.
struct GltfNewNode {
  int parent = 0;  // index in the file
  std::string name;
  Vec3d translation{};       // in the parent
  std::optional<Vec3d> tip;  // position of a further child node, in the node's frame
};

// The file with nodes appended, GLB or JSON as before; everything else is kept byte for byte.
// `bytes` must be readable by parse_gltf.
[[nodiscard]] Result<std::string> add_nodes(std::string_view bytes, std::string_view name,
                                            std::span<const GltfNewNode> added);

}  // namespace shigusa
