// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include "kinematics/forward_kinematics.hpp"
#include "robot/robot.hpp"
#include "robot/settled_posture.hpp"

namespace shigusa {

// Builds a standing body of a robot: every number stays finite.
inline void check_robot(Robot robot) {
  for (const Transformd& x : robot_places(robot)) {
    if (!is_finite(x.translation.x + x.translation.y + x.translation.z)) std::abort();
  }
  robot = with_hands(std::move(robot));
  const auto map = find_humanoid(robot);
  if (!map) return;
  auto body = build_robot(with_ankles(std::move(robot), *map), *map);
  if (!body) return;
  settle(*body);
  for (const double angle : body->home.angles) {
    if (!is_finite(angle)) std::abort();
  }
}

}  // namespace shigusa
