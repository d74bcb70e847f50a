// SPDX-License-Identifier: MIT
#include "kinematics/forward_kinematics.hpp"

#include "core/check.hpp"

namespace shigusa {

Kinematics<double> placed(const BodyModel& body, const State& state) {
  SHG_CHECK(state.angles.size() == body.dofs().size(), "a state has one angle per dof");
  Kinematics<double> kinematics(body);
  forward_kinematics<double>(body, state.angles, kinematics);
  return kinematics;
}

Kinematics<double> home_kinematics(const PosedBody& posed) {
  return placed(posed.body, posed.home);
}

}  // namespace shigusa
