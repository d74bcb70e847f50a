// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "io/gltf_write.hpp"
#include "json_splice.hpp"

namespace shigusa {

Result<std::string> format_vrm_animation(const VrmAnimation& motion) {
  std::string nodes;
  std::string map;
  for (std::size_t i = 0; i < motion.bones.size(); ++i) {
    const auto& [name, parent, offset] = motion.bones[i];
    std::string children;
    for (std::size_t k = i + 1; k < motion.bones.size(); ++k) {
      if (motion.bones[k].parent != static_cast<int>(i)) continue;
      children += fmt::format("{}{}", children.empty() ? "" : ",", k);
    }
    if (!children.empty()) children = fmt::format(R"(,"children":[{}])", children);
    const char* comma = i == 0 ? "" : ",";
    nodes += fmt::format(R"({}{{"name":{},"translation":{}{}}})", comma, json_quoted(name),
                         json_numbers({offset.x, offset.y, offset.z}), children);
    map += fmt::format(R"({}{}:{{"node":{}}})", comma, json_quoted(name), i);
  }
  const std::string text = fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"shigusa"}},"extensionsUsed":["VRMC_vrm_animation"],)"
      R"("extensions":{{"VRMC_vrm_animation":{{"specVersion":"1.0","humanoid":{{"humanBones":{{{}}}}}}}}},)"
      R"("scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{}]}})",
      map, nodes);
  return add_animations(text, "VRM animation", std::span(&motion.animation, 1));
}

}  // namespace shigusa
