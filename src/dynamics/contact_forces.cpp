// SPDX-License-Identifier: MIT
#include "dynamics/contact_forces.hpp"

#include "body/stance.hpp"

namespace shigusa {

double floor_height(const BodyModel& body) {
  const Foot* foot = base_foot(body);
  return foot == nullptr ? body.base().translation.y : (body.base() * foot->centre).y;
}

}  // namespace shigusa
