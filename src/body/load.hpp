// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>

namespace shigusa {

// A copy of the body with a load (kg, 0..kLoadMax) as a point mass at an effector's point: its
// weight and inertia count for torques, balance and the floor.
[[nodiscard]] BodyModel with_load(const BodyModel& body, int effector, double load);

}  // namespace shigusa
