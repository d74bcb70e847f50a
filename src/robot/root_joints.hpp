// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>

namespace shigusa {

// Values (rad, or m) of the six joints that carry a robot's root, relative to their fixed
// positions.
using RootValues = std::array<double, 6>;

// Joint values that bring the root to a placement in the robot's world; empty if they cannot.
// `begin`: initial values, such as those of the previous frame.
[[nodiscard]] std::optional<RootValues> root_values(const RobotFrame& robot, const Transformd& root,
                                                    RootValues begin);

}  // namespace shigusa
