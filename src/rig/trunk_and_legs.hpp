// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>

namespace shigusa {

// Directions of trunk and legs in one posture.
struct TrunkAndLegs {
  Vec3d trunk;  // from mid-hip to mid-shoulder
  Vec3d legs;   // from mid-ankle to mid-hip

  // Axis along which both point, or 0.
  [[nodiscard]] Vec3d common_axis() const;
  // Direction of a body that is straight from ankles to shoulders, or 0.
  [[nodiscard]] Vec3d common_line() const;

  // Directions in the rest pose, in the file's units and axes.
  [[nodiscard]] static TrunkAndLegs at_rest(const Skeleton& skeleton, const HumanoidMap& map);
};

}  // namespace shigusa
