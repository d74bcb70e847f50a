// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <string>
#include <vector>

#include "robot/robot.hpp"

namespace shigusa {

// Knees of a robot that stands are bent by this: straight ones cannot lower the trunk at first.
inline constexpr double kStandingKnee = radians(10.0);
// Elbows that would bend aside are bent by this, ahead.
inline constexpr double kStandingElbow = radians(10.0);

// The posture (dofs, rad) in which a robot begins to move: as it stands where every angle is 0,
// both feet flat, but with its knees bent by kStandingKnee, arms that stick out sideways, ahead or
// up let hang with elbows that bend ahead, and every joint within its limits. Steps that limits do
// not allow are left out: `doubts` tells.
[[nodiscard]] std::vector<double> settled_posture(const BodyModel& body,
                                                  std::vector<Message>& doubts);

// The posture (dofs, rad) of a robot whose joints stand where a key frame has them (Joint::rest):
// exactly, where its feet are flat on one floor and its limits allow it, else the nearest that is,
// with a doubt. Fails where its feet are too far from that.
[[nodiscard]] Result<std::vector<double>> keyframe_posture(const BodyModel& body,
                                                           const Robot& robot,
                                                           const std::string& keyframe,
                                                           std::vector<Message>& doubts);

}  // namespace shigusa
