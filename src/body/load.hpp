// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>

namespace shigusa {

// A copy of the body with a load at an effector's point: its weight and inertia count for torques,
// balance and the floor.
[[nodiscard]] BodyModel with_load(const BodyModel& body, const HeldLoad& load);

// The heaviest load (kg) of a hand in a state.
[[nodiscard]] double heaviest_load(const State& state);

}  // namespace shigusa
