// SPDX-License-Identifier: MIT
#include "criteria/work.hpp"

#include "dynamics/inverse_dynamics.hpp"

namespace shigusa {

double full_work(const BodyModel& body, double share) {
  return share * body.mass() * kGravity * body.stature();
}

}  // namespace shigusa
