// SPDX-License-Identifier: MIT
#include "rollout/posture_law.hpp"

namespace shigusa {

ArmAtStart arm_at_start(const BodyModel& body, const ArmLinks& links, double side) {
  const Kinematics<double> standing = start_kinematics(body);
  const Hanging<double> hangs = hanging(standing.link_rotation(links.parent), side);
  const Shrug<double> rises = shrugged(transpose_times(standing.link_rotation(links.chest),
                                                       -standing.link_rotation(links.upper).cy));
  return {hangs.flexion, hangs.abduction, rises.elevation, rises.protraction};
}

}  // namespace shigusa
