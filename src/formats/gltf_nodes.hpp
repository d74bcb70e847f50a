// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <span>
#include <string>
#include <string_view>

namespace shigusa {

// The member of a node's extras by which readers know one that add_nodes has added: it is of the
// skeleton, though no skin binds it.
inline constexpr std::string_view kAddedNode = "shigusa_added";

// A node to hang on one that a glTF file has.
struct GltfNewNode {
  int parent = 0;  // index in the file
  std::string name;
  Vec3d translation{};       // in the parent
  std::optional<Vec3d> tip;  // in the node: of another one that hangs on it
};

// The file with nodes added behind its own, GLB or JSON as it was; all else stays, byte for byte.
// `bytes` are of a file that parse_gltf reads.
[[nodiscard]] Result<std::string> add_nodes(std::string_view bytes, std::string_view name,
                                            std::span<const GltfNewNode> added);

}  // namespace shigusa
