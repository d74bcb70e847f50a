// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/error.hpp>

namespace shigusa {

// A robot of less or more than these heights (m) is likely in another unit than metres.
inline constexpr double kRobotLeastStature = 0.3;
inline constexpr double kRobotMostStature = 3.0;

// A doubt about a robot of that stature (m), with the unit that its file is likely in; none where
// robots are that tall.
[[nodiscard]] std::optional<Message> doubt_of_size(double stature);

}  // namespace shigusa
