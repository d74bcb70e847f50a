// SPDX-License-Identifier: MIT
#include "humanoid_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/core/names.hpp>
#include <shigusa/io/file.hpp>
#include <shigusa/project/task_file.hpp>

namespace shigusa {
namespace {

std::vector<std::string> bone_names() {
  std::vector<std::string> names;
  for (int b = 0; b < kHumanoidBoneCount; ++b) {
    names.emplace_back(humanoid_bone_name(static_cast<HumanoidBone>(b)));
  }
  return names;
}

}  // namespace

Result<HumanoidMap> requested_bones(const BoneRequest& request,
                                    const std::vector<std::string>& nodes,
                                    const std::string& file) {
  const std::vector<std::string> bones = bone_names();
  HumanoidMap map;
  const auto wrong = [](std::string message) {
    return fail(ErrorCode::invalid_argument, std::move(message), "map");
  };
  for (const auto& [bone_name, node_name] : request) {
    const auto bone = std::find(bones.begin(), bones.end(), bone_name);
    if (bone == bones.end()) return wrong(unknown_name("bone", bone_name, bones));
    const auto node = std::find(nodes.begin(), nodes.end(), node_name);
    if (node == nodes.end() || node_name.empty()) {
      const std::string_view near = nearest_name(node_name, nodes);
      return wrong(fmt::format("{} has no '{}' for {}{}", file, node_name.substr(0, 80), bone_name,
                               near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
    }
    const auto place = static_cast<int>(node - nodes.begin());
    int& told = map.node[static_cast<std::size_t>(bone - bones.begin())];
    if (told >= 0) return wrong(fmt::format("{} is told twice", bone_name));
    if (std::find(map.node.begin(), map.node.end(), place) != map.node.end()) {
      return wrong(fmt::format("'{}' is told to be two bones", node_name));
    }
    told = place;
  }
  return map;
}

Result<BoneRequest> bone_request(const Json& json) {
  const auto wrong = [] {
    return fail(ErrorCode::invalid_argument,
                R"(must be an object of bones and nodes: {"right_hand": "Bone_17"})");
  };
  if (!json.is_object()) return wrong();
  BoneRequest request;
  for (const auto& [bone, node] : json.items()) {
    if (!node.is_string()) return wrong();
    request.emplace_back(bone, node.get<std::string>());
  }
  return request;
}

Result<BoneRequest> read_bone_request(const std::filesystem::path& path) {
  const Result<std::string> text = read_text_file(path, kTaskMaxBytes);
  if (!text) return tl::unexpected(text.error());
  const std::string name = path.filename().string();
  const Result<Json> json = parse_json(*text, name);
  if (!json) return tl::unexpected(json.error());
  Result<BoneRequest> request = bone_request(*json);
  if (!request) return fail(request.error().code, request.error().message, name);
  return request;
}

}  // namespace shigusa
