// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/run.hpp>
#include <string_view>
#include <vector>

#include "kinematics/forward_kinematics.hpp"
#include "nlp/variable_metric.hpp"

namespace shigusa::bench {

// Checks reachability by a method independent of closest_reach: variable-metric minimisation within
// the joint limits, from many random postures, of
//
//   ½ |hand - goal|² + ½ Σ |sole corner - its position|²
//
// for a single posture. Three corners of each planted foot fix its position and tilt. At a
// reachable goal the minimum is 0. Only the forward kinematics is shared with the code under test.
class IndependentReach : private SmoothFunction {
 public:
  // m, tolerance of hand and corners: a tenth of that of motions.
  static constexpr double kThere = 1e-4;

  // PreconditionError if the body has no effector of that name. The body must outlive this object.
  IndependentReach(const PosedBody& posed, std::string_view effector);

  // (dofs, rad) a posture within the limits that has the effector at the goal (m, world) and the
  // feet at their positions of the start posture: the first one found from the start posture and
  // `starts` random ones. Empty if none was found.
  [[nodiscard]] std::optional<std::vector<double>> posture(const Vec3d& goal, int starts,
                                                           Random& random);

 private:
  // a point of a link with its target (m, world)
  struct Held {
    int link = 0;
    Vec3d point{};  // m, link frame
    Vec3d place{};
  };

  double evaluate(std::span<const double> z, std::span<double> gradient) override;
  void add_limits();
  [[nodiscard]] bool descend(std::span<double> z);

  const BodyModel& body_;
  std::vector<double> home_;         // (dofs) rad
  std::vector<Held> held_;           // the effector first
  std::vector<LinearLimit> limits_;  // of z, the angles less the start's
  std::vector<double> size_;         // (dofs) 1
  std::vector<double> angles_;       // (dofs) rad
  std::vector<double> rows_;         // of the Jacobian at a start
  Kinematics<double> placed_;
  VariableMetric metric_;
};

// (rad) Largest violation of a joint limit by the angles (dofs, rad), from the body's own numbers
// rather than the library's measures; 0 if there is none.
[[nodiscard]] double excess_of(const BodyModel& body, std::span<const double> angles);

}  // namespace shigusa::bench
