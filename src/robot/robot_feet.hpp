// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "robot_joints.hpp"

namespace shigusa {

// The sole of a robot's foot in the posture of PlacedRobot: corners in its world (m), at one
// height, counter-clockwise from above.
struct RobotSole {
  std::array<Vec3d, 4> corners;
  bool guessed = false;  // by a person's proportions
};

// `links`: those that are rigid with the foot; `ankle`: the ankle joint's centre.
[[nodiscard]] RobotSole robot_sole(const Robot& robot, const PlacedRobot& placed,
                                   const std::vector<int>& links, const Vec3d& ankle,
                                   double stature);

}  // namespace shigusa
