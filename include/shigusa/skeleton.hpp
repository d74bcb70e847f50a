// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/message.hpp>
#include <shigusa/quat.hpp>
#include <shigusa/transform.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// One named node of a hierarchy; its frame at rest has the parent's orientation.
struct SkeletonNode {
  std::string name;       ///< unique; empty for an end site
  int parent = -1;        ///< index of an earlier node; -1 for a root
  Vec3d offset{};         ///< m, origin in the parent's frame at rest
  bool end_site = false;  ///< marks the tip of its parent; carries no motion
};

/// A hierarchy of named nodes, parents before children: the form that files hold. The kernel
/// computes on BodyModel instead.
struct Skeleton {
  std::vector<SkeletonNode> nodes;  ///< parents before children

  /// Index of the node of that name, or -1.
  [[nodiscard]] int find(std::string_view name) const;
};

/// A node's place in its parent's frame.
struct LocalTransform {
  Vec3d translation{};  ///< m
  Quatd rotation{};     ///< from the node's axes to its parent's
};

/// Motion of a skeleton at a constant frame time.
struct SkeletonClip {
  double frame_time = 1.0 / 60.0;     ///< s
  int frames = 0;                     ///< postures, at equal times
  std::vector<LocalTransform> local;  ///< (frames × nodes) each node in its parent's frame

  /// The transforms of all nodes at one frame, 0..frames-1.
  [[nodiscard]] const LocalTransform* frame(const Skeleton& skeleton, int index) const {
    return local.data() + static_cast<std::size_t>(index) * skeleton.nodes.size();
  }
};

/// A skeleton with its motion: what a motion file holds. Metres, seconds, radians.
struct SkeletonMotion {
  Skeleton skeleton;  ///< the nodes at rest
  SkeletonClip clip;  ///< how they move
};

/// Origins of all nodes at rest: (nodes), in the file's world, metres.
[[nodiscard]] std::vector<Vec3d> rest_origins(const Skeleton& skeleton);

/// World transforms of all nodes at one frame: (nodes), in the file's world, metres.
[[nodiscard]] std::vector<Transformd> world_transforms(const Skeleton& skeleton,
                                                       const SkeletonClip& clip, int frame);

/// The bones that a motion needs, named as in the VRM 1.0 humanoid vocabulary.
enum class HumanoidBone {
  hips,             ///< the root of what moves
  neck,             ///< above the shoulders
  head,             ///< turns with the gaze
  left_upper_leg,   ///< thigh: turns about the hip
  left_lower_leg,   ///< shank: turns about the knee
  left_foot,        ///< turns about the ankle
  left_toes,        ///< turn about the ball of the foot
  right_upper_leg,  ///< thigh: turns about the hip
  right_lower_leg,  ///< shank: turns about the knee
  right_foot,       ///< turns about the ankle
  right_toes,       ///< turn about the ball of the foot
  left_upper_arm,   ///< turns about the shoulder
  left_lower_arm,   ///< turns about the elbow
  left_hand,        ///< turns about the wrist
  right_upper_arm,  ///< turns about the shoulder
  right_lower_arm,  ///< turns about the elbow
  right_hand,       ///< turns about the wrist
  spine,            ///< the lowest joint of the trunk; from here on a skeleton may lack bones
  chest,            ///< the joint above it
  upper_chest,      ///< the joint above that
  left_shoulder,    ///< clavicle
  right_shoulder,   ///< clavicle
};
/// Number of the bones.
inline constexpr int kHumanoidBoneCount = 22;

/// "right_upper_leg".
[[nodiscard]] std::string_view humanoid_bone_name(HumanoidBone bone);

/// Which node of a skeleton is which bone; the node's origin is the bone's proximal joint.
struct HumanoidMap {
  std::array<int, kHumanoidBoneCount> node;  ///< node index, or -1 where the skeleton has none
  std::vector<Message> doubts;               ///< sentences for a person: guesses that may be wrong
  bool mirrored = false;  ///< what is called left is on the body's right: a mirrored file

  /// No bone is known.
  HumanoidMap() { node.fill(-1); }
  /// The node that a bone is, or -1.
  [[nodiscard]] int operator[](HumanoidBone bone) const {
    return node[static_cast<std::size_t>(bone)];
  }
  /// The same, to be changed.
  [[nodiscard]] int& operator[](HumanoidBone bone) { return node[static_cast<std::size_t>(bone)]; }
};

}  // namespace shigusa
