// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/goal.hpp>
#include <string>
#include <vector>

#include "outside.hpp"

// Limbs and obstacles in a geometry independent of the kernel's: bones as lines between nodes, and
// boxes with rounded edges.
namespace shigusa::bench {

// m, signed distance of a point from an obstacle's surface, negative inside.
[[nodiscard]] double distance_from(const Obstacle& obstacle, const Vec3d& point);

// A bone between two nodes.
struct Bone {
  std::string from;
  std::string to;
};
// Bones of arms, legs, trunk and neck whose nodes the motion has.
[[nodiscard]] std::vector<Bone> bones_of(const BodyModel& body, const OutsideMotion& motion);

struct BoneInBox {
  double depth = 0.0;  // m, of the bone's axis, in excess of the first frame
  Bone bone;
  std::string obstacle;
};
// Deepest penetration in any frame. `resting`: only of resting hands in their supports; else of
// everything else.
[[nodiscard]] BoneInBox deepest_bone(const Task& task, const Candidate& candidate,
                                     const OutsideMotion& motion, bool resting = false);

}  // namespace shigusa::bench
