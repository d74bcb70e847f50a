// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body_model.hpp>
#include <shigusa/message.hpp>
#include <vector>

namespace shigusa {

// Knees of a robot that stands are bent by this: straight ones cannot lower the trunk at first.
inline constexpr double kStandingKnee = radians(10.0);

// The posture (dofs, rad) in which a robot begins to move: as it stands where every angle is 0,
// both feet flat, but with its knees bent by kStandingKnee, arms that stick out sideways, ahead or
// up let hang, and every joint within its limits. Steps that limits do not allow are left out:
// `doubts` tells.
[[nodiscard]] std::vector<double> settled_posture(const BodyModel& body,
                                                  std::vector<Message>& doubts);

}  // namespace shigusa
