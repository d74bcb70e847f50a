// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// The bones that a motion needs, named as in the VRM 1.0 humanoid vocabulary.
enum class HumanoidBone {
  hips,
  neck,
  head,
  left_upper_leg,
  left_lower_leg,
  left_foot,
  left_toes,
  right_upper_leg,
  right_lower_leg,
  right_foot,
  right_toes,
  left_upper_arm,
  left_lower_arm,
  left_hand,
  right_upper_arm,
  right_lower_arm,
  right_hand,
  // what a skeleton may lack: joints between hips and arms, from below, and the clavicles'
  spine,
  chest,
  upper_chest,
  left_shoulder,
  right_shoulder,
};
// Number of the bones.
inline constexpr int kHumanoidBoneCount = 22;

// "right_upper_leg".
[[nodiscard]] std::string_view humanoid_bone_name(HumanoidBone bone);

// Which node of a skeleton is which bone; the node's origin is the bone's proximal joint.
struct HumanoidMap {
  std::array<int, kHumanoidBoneCount> node;  // node index, or -1 where the skeleton has none
  std::vector<std::string> doubts;           // sentences for a person: guesses that may be wrong

  // No bone is known.
  HumanoidMap() { node.fill(-1); }
  // The node that a bone is, or -1.
  [[nodiscard]] int operator[](HumanoidBone bone) const {
    return node[static_cast<std::size_t>(bone)];
  }
  // The same, to be changed.
  [[nodiscard]] int& operator[](HumanoidBone bone) { return node[static_cast<std::size_t>(bone)]; }
};

}  // namespace shigusa
