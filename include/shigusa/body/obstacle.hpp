// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math/quat.hpp>
#include <string>

namespace shigusa {

// Something in the world that a body should not pass through: a box with round edges. One without
// size is a sphere, one with size along a single axis a capsule.
struct Obstacle {
  std::string name;     // "table"
  Vec3d position{};     // m, world, of its middle
  Quatd rotation{};     // R_WO
  Vec3d size{};         // m, along its own axes, ≥ 0
  double radius = 0.0;  // m, ≥ 0, beyond the size on all sides
};

}  // namespace shigusa
