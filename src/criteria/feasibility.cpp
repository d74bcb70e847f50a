// SPDX-License-Identifier: MIT
#include <shigusa/criteria/feasibility.hpp>

#include "replay.hpp"

namespace shigusa {

double feasibility_penalty(const BodyModel& body, const Motion& motion,
                           const FeasibilitySettings& settings) {
  return replayed(body, motion, Feasibility<double>(body, settings));
}

}  // namespace shigusa
