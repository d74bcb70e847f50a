// SPDX-License-Identifier: MIT
#include "kinematics/limb.hpp"

namespace shigusa {

PelvisRange::PelvisRange(const HingedLimb& leg, const Limits& limits)
    : leg_(leg),
      limits_(limits),
      shortest_(leg.length(limits.knee_upper)),
      longest_(leg.length(limits.knee_lower)) {}

double PelvisRange::excess(double lean, double length) const {
  const double knee = leg_.bend(length);
  const double ankle = lean - leg_.direction(knee);
  const double gap = max(length - leg_.longest(), leg_.shortest() - length);
  double most = gap > 0.0 ? atan2(gap, leg_.longest()) : 0.0;
  for (const double over : {knee - limits_.knee_upper, limits_.knee_lower - knee,
                            ankle - limits_.ankle_upper, limits_.ankle_lower - ankle}) {
    most = max(most, over);
  }
  return most;
}

}  // namespace shigusa
