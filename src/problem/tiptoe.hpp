// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "criteria/support_zone.hpp"
#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

// (dofs, rad) the least change of the angles that, to first order, moves the centre of mass by
// `offset` (m, world) along the floor; nothing where no change does.
[[nodiscard]] std::vector<double> change_of_plumb_line(const BodyModel& body,
                                                       const Kinematics<double>& kinematics,
                                                       const Vec3d& offset);

// The support that a posture with lifted heels has to be above.
class Tiptoe {
 public:
  // angles: (dofs) rad
  Tiptoe(const BodyModel& body, std::span<const double> angles);

  // Some heel leaves the floor.
  [[nodiscard]] bool lifted() const { return lifted_ != 0; }
  // From the plumb line of the centre of mass (m, world) to the middle of what bears it; nothing
  // where it stands kPoised within the edge.
  [[nodiscard]] Vec3d offset_from(const Vec3d& centre_of_mass) const;

 private:
  LiftedHeels lifted_ = 0;
  std::vector<SupportEdge> edges_;
  Vec3d middle_{};
};
inline constexpr double kPoised = 0.025;  // m

}  // namespace shigusa
