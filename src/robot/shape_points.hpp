// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "robot/robot.hpp"

namespace shigusa {

// Points all over the surface of a shape (m, link frame), spaced evenly by about `apart` (m), but
// at most `most` along an edge; empty for a shape without a size.
[[nodiscard]] std::vector<Vec3d> surface_points(const Robot::Shape& shape, double apart, int most);

}  // namespace shigusa
