// SPDX-License-Identifier: MIT
#include "gltf_vrm.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "core/say.hpp"
#include "core/text.hpp"
#include "gltf_json.hpp"
#include "human/landmark_points.hpp"

namespace shigusa {
namespace {

// Member by name, or null if absent or if `json` is no object.
const GltfJson& member(const GltfJson& json, const char* key) {
  static const GltfJson none;
  const auto found = json.is_object() ? json.find(key) : json.end();
  return json.is_object() && found != json.end() ? *found : none;
}

// Bone name in snake case: "left_upper_leg" for "leftUpperLeg".
std::string snake_case(std::string_view camel) {
  std::string snake;
  for (const char c : camel) {
    if (is_upper(c)) snake += '_';
    snake += lower(c);
  }
  return snake;
}

class BoneReader {
 public:
  explicit BoneReader(int nodes) : nodes_(nodes) {}

  void bone(const GltfJson& name, const GltfJson& node) {
    // some writers give missing bones the node -1
    if (node.is_number_integer() && node == -1) return;
    if (!node.is_number_unsigned() || node >= static_cast<std::uint64_t>(nodes_)) {
      return wrong(
          say("vrm_node", json_shown(name, kLongest), json_shown(node, kLongest), nodes_ - 1));
    }
    const int index = node.get<int>();
    const std::string own = name.is_string() ? name.get<std::string>() : std::string();
    bones_.all.emplace_back(own, index);
    const std::string ours = snake_case(own);
    for (const HumanoidBone bone : kHumanoidBones) {
      if (ours != humanoid_bone_name(bone)) continue;
      int& mapped = bones_.map[bone];
      if (mapped >= 0 && mapped != index) {
        wrong(say("vrm_twice", json_shown(name, kLongest), mapped, index));
      } else {
        mapped = index;
      }
    }
  }

  VrmBones finish() {
    if (wrong_ == 1)
      bones_.doubts.push_back(say("at_place", say("vrm_map_is_wrong"), first_wrong_));
    if (wrong_ > 1) {
      bones_.doubts.push_back(say("vrm_map_wrong", wrong_, first_wrong_));
    }
    return std::move(bones_);
  }

  void version(VrmVersion version) { bones_.version = version; }

 private:
  void wrong(Message message) {
    if (++wrong_ == 1) first_wrong_ = std::move(message);
  }

  static constexpr std::size_t kLongest = 40;  // of a value in a message

  VrmBones bones_;
  int nodes_;
  int wrong_ = 0;  // entries of the map
  Message first_wrong_;
};

}  // namespace

VrmBones read_vrm_bones(const GltfJson& file, int nodes) {
  const GltfJson& extensions = member(file, "extensions");
  const GltfJson& old_bones = member(member(member(extensions, "VRM"), "humanoid"), "humanBones");
  const GltfJson& bones = member(member(member(extensions, "VRMC_vrm"), "humanoid"), "humanBones");
  BoneReader reader(nodes);
  if (bones.is_object()) {
    reader.version(VrmVersion::v1);
    for (const auto& [name, bone] : bones.items()) reader.bone(name, member(bone, "node"));
  } else if (old_bones.is_array()) {
    reader.version(VrmVersion::v0);
    for (const GltfJson& bone : old_bones) reader.bone(member(bone, "bone"), member(bone, "node"));
  }
  return reader.finish();
}

}  // namespace shigusa
