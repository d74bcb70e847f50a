// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "criteria/support_zone.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// (dofs, rad) the smallest change of the angles that, to first order, moves the centre of mass by
// `offset` (m, world) along the floor; zero if no change does.
[[nodiscard]] std::vector<double> change_of_plumb_line(const BodyModel& body,
                                                       const Kinematics<double>& kinematics,
                                                       const Vec3d& offset);

// The support polygon of a posture with lifted heels.
class Tiptoe {
 public:
  // angles: (dofs) rad
  Tiptoe(const ReachProblem& problem, std::span<const double> angles);

  // Whether some heel leaves the floor.
  [[nodiscard]] bool lifted() const { return lifted_ != 0; }
  // Offset from the plumb line of the centre of mass (m, world) to the middle of the polygon; zero
  // if it is kPoised within the edge.
  [[nodiscard]] Vec3d offset_from(const Vec3d& centre_of_mass) const;

 private:
  LiftedHeels lifted_ = 0;
  std::vector<SupportEdge> edges_;
  Vec3d middle_{};
};
inline constexpr double kPoised = 0.025;  // m

}  // namespace shigusa
