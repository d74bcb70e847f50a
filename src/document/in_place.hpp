// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>
#include <vector>

#include "kinematics/rig.hpp"

namespace shigusa {

// Keeps a node (frames × nodes) along the floor where it is in the first frame: what it travels
// there is taken off, and what it rises stays. `parent`: from its parent, which stays, to the
// world, with scales; `up`: unit vector in that world.
void stay_in_place(int node, const Mat3d& parent, const Vec3d& up, std::size_t nodes,
                   std::vector<LocalTransform>& local);

// The same for the hips of a rig, in the world that it leaves in.
void stay_in_place(const Rig& rig, RigMotion& motion);

}  // namespace shigusa
