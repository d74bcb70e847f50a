// SPDX-License-Identifier: MIT
#include <shigusa/criteria/torque.hpp>

#include "replay.hpp"

namespace shigusa {

double torque_penalty(const BodyModel& body, const Motion& motion, const TorqueSettings& settings) {
  return replayed(body, motion, Torque<double>(body, settings));
}

}  // namespace shigusa
