// SPDX-License-Identifier: MIT
#pragma once

#include "body/body_constants.hpp"
#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

// Centre of mass of the whole body (m, world): Σ m_i c_i / Σ m_i.
template <class S>
[[nodiscard]] Vec3<S> centre_of_mass(const BodyModel& body, const Kinematics<S>& kinematics) {
  const BodyConstants<Element<S>>& constants = body.constants<Element<S>>();
  Vec3<S> moment = kinematics.point(kBaseLink, constants.base_com) * S(constants.base_mass);
  for (const auto& joint : constants.joints) {
    if (joint.massive) moment += kinematics.point(joint.link, joint.com) * S(joint.mass);
  }
  return moment * S(Element<S>(1) / constants.total_mass);
}

}  // namespace shigusa
