// SPDX-License-Identifier: MIT
#include "stoop_squat_index.hpp"

#include <shigusa/core/check.hpp>
#include <shigusa/kinematics/forward_kinematics.hpp>
#include <string>

namespace shigusa::bench {

double stoop_squat_index(const BodyModel& body, const Clip& clip) {
  Kinematics<double> placed(body);
  // heights (m) of the middle of a joint's two sides, or of the side that the body has
  const auto height = [&](const char* joint) {
    double sum = 0.0;
    int sides = 0;
    for (const char* side : {"right_", "left_"}) {
      const auto dof = body.find_dof(std::string(side) + joint + ".flexion");
      if (!dof) continue;
      sum += placed.origin[static_cast<std::size_t>(*dof)].y;
      ++sides;
    }
    SHG_CHECK(sides > 0, std::string("the body has no ") + joint);
    return sum / sides;
  };
  forward_kinematics<double>(body, clip.frame(0), placed);
  const double hip = height("hip");
  const double shoulder = height("shoulder");
  forward_kinematics<double>(body, clip.frame(clip.frames - 1), placed);
  return 100.0 * (1.0 - (hip - height("hip")) / (shoulder - height("shoulder")));
}

}  // namespace shigusa::bench
