// SPDX-License-Identifier: MIT
#include <shigusa/criteria/joint_range.hpp>

#include "replay.hpp"

namespace shigusa {

double joint_range_penalty(const BodyModel& body, const Motion& motion,
                           const JointRangeSettings& settings) {
  return replayed(body, motion, JointRange<double>(body, settings));
}

}  // namespace shigusa
