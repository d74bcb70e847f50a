// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>
#include <vector>

#include "kinematics/rig.hpp"

namespace shigusa {

// Holds a node (frames × nodes) at its horizontal position of the first frame and keeps its
// vertical motion. `parent`: transform from its fixed parent to the world, with scales; `up`: unit
// vector in that world. Returns what is taken off it in that world (frames).
std::vector<Vec3d> stay_in_place(int node, const Mat3d& parent, const Vec3d& up, std::size_t nodes,
                                 std::vector<LocalTransform>& local);

// Holds the hips of a rig in place, in the world of the exported file.
std::vector<Vec3d> stay_in_place(const Rig& rig, RigMotion& motion);

}  // namespace shigusa
