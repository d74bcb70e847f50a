// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>

namespace shigusa {

// Values (rad, or m) of the six joints that carry a robot's root, beside the places that they keep.
using RootValues = std::array<double, 6>;

// Those with which the root stands in a place of the robot's world; nothing where they cannot take
// it there. `begin`: values to start from, those of the frame before.
[[nodiscard]] std::optional<RootValues> root_values(const RobotFrame& robot, const Transformd& root,
                                                    RootValues begin);

}  // namespace shigusa
