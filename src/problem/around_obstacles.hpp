// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "rollout/reach_problem.hpp"

namespace shigusa {

// Distance (m) that a hand's point keeps from obstacles on its way, beyond half a hand's length;
// near the ends of the way as much less as they are nearer.
inline constexpr double kKeepsOff = 0.14;

// Leads a hand's path around the obstacles if the straight one comes too near to them: first up and
// back, then ahead, or aside. Of some such ways it is the smallest that keeps off, or else the one
// that comes nearest to that.
void go_around_obstacles(const CriteriaContext& context, const Effector& hand, EffectorPath& path);

// Distance (m) that a carried thing's corners keep in the same way.
inline constexpr double kThingKeepsOff = 0.05;

// Leads the path of a carried thing's middle around the obstacles. `corners`: m, from its middle,
// world axes; its turn on the way is left out.
void carry_around_obstacles(const CriteriaContext& context, std::span<const Vec3d> corners,
                            EffectorPath& path);

}  // namespace shigusa
