// SPDX-License-Identifier: MIT
#include "criteria/low_back.hpp"

#include "body/anthropometry.hpp"

namespace shigusa {

BackConstants back_constants(const BodyModel& body) {
  BackConstants back;
  if (const auto spine = body.find_dof(JointKind::spine, FreedomKind::flexion)) {
    const Dof& dof = body.dof(*spine);
    return {{*spine}, 1.0 / dof.torque_negative, 1.0 / dof.torque_positive};
  }
  double hips = 0.0;
  back.dofs = body.dofs_of(JointKind::hip, FreedomKind::flexion);
  for (const int d : back.dofs) hips += body.dof(d).torque_negative;
  if (back.dofs.empty()) return back;
  // strength relative to that man's two hips; the half body's one hip counts for two
  const double strength = hips / (2.0 * kHipFlexion.torque_negative);
  back.per_extension = kBackShareOfHips / (kBackExtension * strength);
  back.per_flexion = kBackShareOfHips / (kBackFlexion * strength);
  return back;
}

}  // namespace shigusa
