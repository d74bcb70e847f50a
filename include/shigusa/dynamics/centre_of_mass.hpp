// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/kinematics/forward_kinematics.hpp>

namespace shigusa {

// Centre of mass of the whole body (m, world): Σ m_i c_i / Σ m_i.
template <class S>
[[nodiscard]] Vec3<S> centre_of_mass(const BodyModel& body, const Kinematics<S>& kinematics) {
  Vec3<S> moment{};
  for (int link = kBaseLink; link < body.dof_count(); ++link) {
    const MassProperties& m = body.link_mass(link);
    if (m.mass > 0.0) moment += kinematics.point(link, m.com) * S(m.mass);
  }
  return moment * S(1.0 / body.mass());
}

}  // namespace shigusa
