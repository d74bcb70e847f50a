// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math/vec3.hpp>
#include <shigusa/motion/clip.hpp>
#include <vector>

namespace shigusa {

// A motion with the quantities that can be read off it. Criteria of the user's own are given this.
struct Motion {
  Clip clip;                                  // joint angles
  std::vector<double> torques;                // (frames × dofs) N·m, dof order of BodyModel
  std::vector<Vec3d> centre_of_mass;          // (frames) m, world
  std::vector<std::vector<Vec3d>> effectors;  // [goal][frame] m, world: where the goal's point is
};

}  // namespace shigusa
