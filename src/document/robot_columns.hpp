// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body_model.hpp>
#include <shigusa/motion.hpp>
#include <vector>

#include "io/csv.hpp"

namespace shigusa {

// A point of shigusa's world (m) in a robot's: x ahead, y to the left, z up.
[[nodiscard]] Vec3d in_robot_world(const Vec3d& point);

// Adds to a table what drives a robot through a motion, in its file's own terms: the root link's
// place "root.x [m]" … and quaternion "root.qx" … in the robot's world, then "JOINT [rad]" (or
// "JOINT [m]" where it slides) for all joints that move, in the file's order, then "JOINT torque [N
// m]" for those that take part.
void add_robot_columns(const BodyModel& body, const Motion& motion,
                       std::vector<CsvColumn>& columns);

}  // namespace shigusa
