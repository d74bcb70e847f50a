// SPDX-License-Identifier: MIT
#include <shigusa/motion.hpp>

#include "core/check.hpp"
#include "core/index.hpp"

namespace shigusa {

int Skeleton::find(std::string_view name) const {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

std::vector<Vec3d> rest_origins(const Skeleton& skeleton) {
  std::vector<Vec3d> at;
  for (const SkeletonNode& node : skeleton.nodes) {
    at.push_back(node.parent < 0 ? node.offset : at[index(node.parent)] + node.offset);
  }
  return at;
}

std::vector<Transformd> world_transforms(const Skeleton& skeleton, const SkeletonClip& clip,
                                         int frame) {
  SHG_CHECK(frame >= 0 && frame < clip.frames,
            "frame " + std::to_string(frame) + " of " + std::to_string(clip.frames));
  const LocalTransform* local = clip.frame(skeleton, frame);
  std::vector<Transformd> world(skeleton.nodes.size());
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Transformd x{to_matrix(local[i].rotation), local[i].translation};
    const int parent = skeleton.nodes[i].parent;
    world[i] = parent < 0 ? x : world[index(parent)] * x;
  }
  return world;
}

}  // namespace shigusa
