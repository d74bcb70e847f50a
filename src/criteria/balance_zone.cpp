// SPDX-License-Identifier: MIT
#include <shigusa/criteria/balance_zone.hpp>

#include "replay.hpp"

namespace shigusa {

double balance_zone_penalty(const BodyModel& body, const Motion& motion,
                            const BalanceZoneSettings& settings) {
  return replayed(body, motion, BalanceZone<double>(body, settings));
}

}  // namespace shigusa
