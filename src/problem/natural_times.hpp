// SPDX-License-Identifier: MIT
#pragma once

#include "rollout/reach_problem.hpp"

namespace shigusa {

// How much quicker a hand's path is in its first half than in its second (EffectorPath::haste), as
// people's are.
[[nodiscard]] double natural_haste(const EffectorPath& path);

// The share of the duration before a hand leaves for its goal (EffectorPath::begin), as people's
// do.
[[nodiscard]] double natural_begin(const EffectorPath& path);

// When the parts of the body change their posture in motions along these paths, as people's do.
[[nodiscard]] PartWindows natural_windows(std::span<const ReachGoal> goals);

}  // namespace shigusa
