// SPDX-License-Identifier: MIT
#include "humanoid_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <shigusa/error.hpp>

#include "core/say.hpp"
#include "files/file.hpp"
#include "human/landmark_points.hpp"
#include "rig/likeness.hpp"

namespace shigusa {
namespace {

constexpr std::size_t kMapMaxBytes = std::size_t{1} << 20;

std::vector<std::string> bone_names() {
  std::vector<std::string> names;
  for (const HumanoidBone bone : kHumanoidBones) names.emplace_back(humanoid_bone_name(bone));
  return names;
}

// Node given by its name, or by its 0-based index in the file, as "#17".
int named_node(const std::string& name, const std::vector<std::string>& nodes,
               const std::vector<int>& indices) {
  const auto node = std::find(nodes.begin(), nodes.end(), name);
  if (node != nodes.end() && !name.empty()) return static_cast<int>(node - nodes.begin());
  int index = -1;
  const char* end = name.data() + name.size();
  if (!name.starts_with('#')) return -1;
  const auto [rest, error] = std::from_chars(name.data() + 1, end, index);
  if (error != std::errc{} || rest != end || index < 0) return -1;
  if (indices.empty()) return index < static_cast<int>(nodes.size()) ? index : -1;
  const auto place = std::find(indices.begin(), indices.end(), index);
  return place == indices.end() ? -1 : static_cast<int>(place - indices.begin());
}

// First names of a file's nodes, for a message.
std::string some_of(const std::vector<std::string>& nodes) {
  constexpr std::size_t kNamesMost = 12;
  constexpr std::size_t kLongestName = 40;
  std::string names;
  std::size_t told = 0;
  for (const std::string& node : nodes) {
    if (told == kNamesMost) break;
    if (node.empty() || node.size() > kLongestName) continue;
    names += (told == 0 ? "" : ", ") + node;
    ++told;
  }
  if (told == nodes.size()) return names;
  return names + fmt::format("{}{} more", told == 0 ? "" : " and ", nodes.size() - told);
}

// Bone assignments in the format that `shigusa body` prints. Its lines of goal places have the same
// names and wider columns.
BoneRequest bones_of_text(std::string_view text) {
  BoneRequest request;
  const std::vector<std::string> bones = bone_names();
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    constexpr std::size_t kColumn = 19;
    const std::size_t gap = line.find(' ');
    const std::size_t node = line.find_first_not_of(' ', gap);
    const std::string bone(line.substr(0, gap));
    const bool known = std::find(bones.begin(), bones.end(), bone) != bones.end();
    if (gap == line.npos || node == line.npos || !known) continue;
    if (node == kColumn || node == gap + 1) request.emplace_back(bone, line.substr(node));
  }
  return request;
}

}  // namespace

Result<HumanoidMap> requested_bones(const BoneRequest& request,
                                    const std::vector<std::string>& nodes, const std::string& file,
                                    const std::vector<int>& indices) {
  const std::vector<std::string> bones = bone_names();
  HumanoidMap map;
  const auto wrong = [](Message message) {
    return fail(ErrorCode::invalid_argument, std::move(message), "map");
  };
  for (const auto& [bone_name, node_name] : request) {
    const auto bone = std::find(bones.begin(), bones.end(), bone_name);
    if (bone == bones.end()) return wrong(unknown_name("bone", bone_name, bones));
    const int place = named_node(node_name, nodes, indices);
    if (place < 0) {
      const std::string_view near = nearest_name(node_name, nodes);
      const std::string name = node_name.substr(0, 80);
      return wrong(near.empty() ? say("no_node_of_name", file, name, bone_name, some_of(nodes))
                                : say("no_node_of_name_near", file, name, bone_name, near));
    }
    int& taken = map.node[static_cast<std::size_t>(bone - bones.begin())];
    if (taken >= 0) return wrong(say("bone_twice", bone_name));
    if (std::find(map.node.begin(), map.node.end(), place) != map.node.end()) {
      return wrong(say("node_of_two_bones", node_name));
    }
    taken = place;
  }
  return map;
}

Result<void> check_likeness(const Landmarks& figure, const BoneRequest& request,
                            const std::string& file) {
  const Message why = request.empty() ? unlike_a_person(figure) : Message();
  if (why.empty()) return {};
  return fail(ErrorCode::invalid_argument, say("no_person", why), file);
}

Result<BoneRequest> bone_request(const Json& json) {
  const auto wrong = [] { return fail(ErrorCode::invalid_argument, say("bones_object")); };
  if (!json.is_object()) return wrong();
  BoneRequest request;
  for (const auto& [bone, node] : json.items()) {
    if (!node.is_string()) return wrong();
    request.emplace_back(bone, node.get<std::string>());
  }
  return request;
}

Result<BoneRequest> read_bone_request(const std::filesystem::path& path) {
  SHG_TRY_ASSIGN(const std::string text, read_text_file(path, kMapMaxBytes));
  const std::string name = path.filename().string();
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (BoneRequest bones = bones_of_text(text); begin == text.npos || text[begin] != '{') {
    if (!bones.empty()) return bones;
    return fail(ErrorCode::invalid_argument, say("names_no_bones"), name);
  }
  SHG_TRY_ASSIGN(const Json json, parse_json(text, name));
  const auto answer = json.find("humanoid");
  return bone_request(answer != json.end() ? *answer : json).map_error(within(name));
}

}  // namespace shigusa
