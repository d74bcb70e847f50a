// SPDX-License-Identifier: MIT
#include <shigusa/criteria/feasibility.hpp>

#include "replay.hpp"

namespace shigusa {

double feasibility_penalty(const BodyModel& body, const Motion& motion,
                           const FeasibilitySettings& settings) {
  return replayed(body, motion, Feasibility<double>(body, settings));
}

std::vector<JointLoad> joint_loads(const BodyModel& body, const Motion& motion) {
  std::vector<JointLoad> loads;
  const Clip& clip = motion.clip;
  for (int d = 0; d < clip.dofs; ++d) {
    const Dof& dof = body.dof(d);
    JointLoad load{.dof = d};
    for (int f = 0; f < clip.frames; ++f) {
      const double torque = motion.torques[static_cast<std::size_t>(f * clip.dofs + d)];
      const double share =
          torque > 0.0 ? torque / dof.torque_positive : -torque / dof.torque_negative;
      if (share > load.share) load = {d, torque, share, f * clip.frame_time};
    }
    loads.push_back(load);
  }
  return loads;
}

}  // namespace shigusa
