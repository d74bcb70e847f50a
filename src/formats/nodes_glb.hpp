// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>
#include <string_view>

namespace shigusa {

// Name of the animation that holds the pose of nodes.
inline constexpr std::string_view kPosedNodes = "pose";

// A skeleton as GLB.
struct NodesFile {
  std::string bytes{};
  bool posed = false;  // has the animation kPosedNodes, of one frame
};

// Converts the nodes of a host's skeleton (shigusa_character_of_nodes) to a GLB file, node by node.
// Errors state the node; `name` stands for the text in them.
[[nodiscard]] Result<NodesFile> glb_of_nodes(std::string_view json, const std::string& name);

}  // namespace shigusa
