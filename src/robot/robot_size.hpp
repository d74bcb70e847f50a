// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/error.hpp>

namespace shigusa {

// Range of heights (m) outside which a robot's file is probably not in metres.
inline constexpr double kRobotLeastStature = 0.3;
inline constexpr double kRobotMostStature = 3.0;

// Doubt about a robot of that stature (m), with the probable unit of its file; empty for a usual
// height.
[[nodiscard]] std::optional<Message> doubt_of_size(double stature);

}  // namespace shigusa
