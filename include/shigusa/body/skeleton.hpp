// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math/quat.hpp>
#include <shigusa/math/transform.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// One named node of a hierarchy; its frame at rest has the parent's orientation.
struct SkeletonNode {
  std::string name;       // unique; empty for an end site
  int parent = -1;        // index of an earlier node; -1 for a root
  Vec3d offset{};         // m, origin in the parent's frame at rest
  bool end_site = false;  // marks the tip of its parent; carries no motion
};

// A hierarchy of named nodes, parents before children: the form that files hold. The kernel
// computes on BodyModel instead.
struct Skeleton {
  std::vector<SkeletonNode> nodes;  // parents before children

  // Index of the node of that name, or -1.
  [[nodiscard]] int find(std::string_view name) const;
};

// A node's place in its parent's frame.
struct LocalTransform {
  Vec3d translation{};  // m
  Quatd rotation{};     // from the node's axes to its parent's
};

// Motion of a skeleton at a constant frame time.
struct SkeletonClip {
  double frame_time = 1.0 / 60.0;     // s
  int frames = 0;                     // postures, at equal times
  std::vector<LocalTransform> local;  // (frames × nodes) each node in its parent's frame

  // The transforms of all nodes at one frame, 0..frames-1.
  [[nodiscard]] const LocalTransform* frame(const Skeleton& skeleton, int index) const {
    return local.data() + static_cast<std::size_t>(index) * skeleton.nodes.size();
  }
};

// A skeleton with its motion: what a motion file holds. Metres, seconds, radians.
struct SkeletonMotion {
  Skeleton skeleton;  // the nodes at rest
  SkeletonClip clip;  // how they move
};

// Origins of all nodes at rest: (nodes), in the file's world, metres.
[[nodiscard]] std::vector<Vec3d> rest_origins(const Skeleton& skeleton);

// World transforms of all nodes at one frame: (nodes), in the file's world, metres.
[[nodiscard]] std::vector<Transformd> world_transforms(const Skeleton& skeleton,
                                                       const SkeletonClip& clip, int frame);

}  // namespace shigusa
