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

// Start posture (dofs, rad) of a robot: standing as at zero angles, both feet flat, but with knees
// bent by kStandingKnee, arms that stick out sideways, ahead or up hanging with elbows that bend
// forwards, and every joint within its limits. Steps that the limits prevent are left out, with
// doubts in `doubts`.
[[nodiscard]] std::vector<double> settled_posture(const BodyModel& body,
                                                  std::vector<Message>& doubts);

// Start posture (dofs, rad) from a key frame (Joint::rest): exact if its feet are flat on one floor
// and within its limits, else the nearest posture for which that holds, with a doubt. Fails if
// the feet are too far off.
[[nodiscard]] Result<std::vector<double>> keyframe_posture(const BodyModel& body,
                                                           const Robot& robot,
                                                           const std::string& keyframe,
                                                           std::vector<Message>& doubts);

}  // namespace shigusa
