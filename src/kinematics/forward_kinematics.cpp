// SPDX-License-Identifier: MIT
#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

Kinematics<double> start_kinematics(const BodyModel& body) {
  Kinematics<double> start(body);
  forward_kinematics<double>(body, body.start(), start);
  return start;
}

}  // namespace shigusa
