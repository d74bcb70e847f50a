// SPDX-License-Identifier: MIT
#include <shigusa/criteria/discomfort.hpp>

#include "replay.hpp"

namespace shigusa {

double discomfort_penalty(const BodyModel& body, const Motion& motion,
                          const DiscomfortSettings& settings) {
  return replayed(body, motion, Discomfort<double>(body, settings));
}

}  // namespace shigusa
