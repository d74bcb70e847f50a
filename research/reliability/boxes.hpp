// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/goal.hpp>
#include <string>
#include <vector>

#include "outside.hpp"

// Limbs and things in the way, by another geometry than the kernel's: the bones' lines themselves,
// from point to point, in boxes with round edges.
namespace shigusa::bench {

// m, of a point from an obstacle's surface, less than 0 inside.
[[nodiscard]] double distance_from(const Obstacle& obstacle, const Vec3d& point);

// Two nodes with a bone between them.
struct Bone {
  std::string from;
  std::string to;
};
// The bones of arms, legs, trunk and neck that the motion has nodes for.
[[nodiscard]] std::vector<Bone> bones_of(const BodyModel& body, const OutsideMotion& motion);

struct BoneInBox {
  double depth = 0.0;  // m, of the bone's line, beyond what the first frame has
  Bone bone;
  std::string obstacle;
};
// The deepest of any frame. `resting`: of the hands that rest, in what they rest on; else of all
// others.
[[nodiscard]] BoneInBox deepest_bone(const Task& task, const Candidate& candidate,
                                     const OutsideMotion& motion, bool resting = false);

}  // namespace shigusa::bench
