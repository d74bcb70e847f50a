// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>

namespace shigusa {

// The direction of a trunk and legs in one posture.
struct TrunkAndLegs {
  Vec3d trunk;  // from between the hips to between the shoulders
  Vec3d legs;   // from between the ankles to between the hips

  // The axis that both point along, or 0.
  [[nodiscard]] Vec3d common_axis() const;
  // The direction of a body that is straight from the ankles to the shoulders, or 0.
  [[nodiscard]] Vec3d common_line() const;

  // Those of the rest pose, in the file's units and axes.
  [[nodiscard]] static TrunkAndLegs at_rest(const Skeleton& skeleton, const HumanoidMap& map);
};

}  // namespace shigusa
