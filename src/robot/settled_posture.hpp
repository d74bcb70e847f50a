// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <string>
#include <vector>

#include "robot/robot.hpp"

namespace shigusa {

// Bend of a standing robot's knees: straight ones cannot lower the trunk at first order.
inline constexpr double kStandingKnee = radians(10.0);
// Forward bend given to elbows that would bend sideways.
inline constexpr double kStandingElbow = radians(10.0);

// Brings a robot as build_robot made it home: it stands as at zero angles, both feet flat, but
// with knees bent by kStandingKnee, arms that stick out sideways, ahead or up hanging with elbows
// that bend forwards, and every joint within its limits. Steps that the limits prevent are left
// out, with doubts.
void settle(PosedBody& robot);

// Brings a robot to a key frame of its file (Joint::rest): exactly if its feet are flat on one
// floor and within its limits, else to the nearest posture for which that holds, with a doubt.
// Fails if the feet are too far off.
[[nodiscard]] Result<void> settle_at_keyframe(PosedBody& robot, const Robot& file,
                                              const std::string& keyframe);

}  // namespace shigusa
