// SPDX-License-Identifier: MIT
#include "criteria/balance.hpp"

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

Vec3d support_centre(const BodyModel& body, const State& start) {
  const Kinematics<double> kinematics = placed(body, start);
  Vec3d sum{};
  for (const Foot& foot : body.feet()) sum += kinematics.point(foot.link, foot.centre);
  return body.feet().empty() ? body.base().translation
                             : sum * (1.0 / static_cast<double>(body.feet().size()));
}

}  // namespace shigusa
