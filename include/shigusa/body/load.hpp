// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>

namespace shigusa {

inline constexpr double kLoadMax = 500.0;  // kg

// The body with a load (kg, 0..kLoadMax) at an effector's point, as if it were there in a point:
// its weight and inertia count for torques, balance and the floor.
[[nodiscard]] BodyModel with_load(const BodyModel& body, int effector, double load);

}  // namespace shigusa
