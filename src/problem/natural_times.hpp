// SPDX-License-Identifier: MIT
#pragma once

#include "rollout/reach_problem.hpp"

namespace shigusa {

// Haste of a hand's path in its first half over its second (EffectorPath::haste), by recorded
// people.
[[nodiscard]] double natural_haste(const EffectorPath& path);

// Share of the duration before a hand leaves for its goal (EffectorPath::begin), by recorded
// people.
[[nodiscard]] double natural_begin(const EffectorPath& path);

// Timing of the body parts' change of posture in motions along these paths, by recorded people.
[[nodiscard]] PartWindows natural_windows(std::span<const ReachGoal> goals);

}  // namespace shigusa
