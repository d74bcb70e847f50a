// SPDX-License-Identifier: MIT
#include <shigusa/criteria/joint_acceleration.hpp>

#include "replay.hpp"

namespace shigusa {

double joint_acceleration_penalty(const BodyModel& body, const Motion& motion,
                                  const JointAccelerationSettings& settings) {
  return replayed(body, motion, JointAcceleration<double>(body, settings));
}

}  // namespace shigusa
