// SPDX-License-Identifier: MIT
#include <shigusa/criteria/centre_of_pressure.hpp>

#include "replay.hpp"

namespace shigusa {

double pressure_penalty(const BodyModel& body, const Motion& motion,
                        const PressureSettings& settings) {
  return replayed(body, motion, PressureZone<double>(body, settings));
}

}  // namespace shigusa
