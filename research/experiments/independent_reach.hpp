// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/run.hpp>
#include <string_view>
#include <vector>

#include "kinematics/forward_kinematics.hpp"
#include "nlp/variable_metric.hpp"

namespace shigusa::bench {

// Says whether a body can be where a goal is, by a way that closest_reach does not take: a variable
// metric method over the joint limits, from many random postures, that minimises
//
//   ½ |hand - goal|² + ½ Σ |corner of a sole - where it stands|²
//
// of one posture alone. Three corners of each planted foot hold its place and its tilt. A
// goal within reach makes all of it 0. Only the placement of links is shared with what is judged.
class IndependentReach : private SmoothFunction {
 public:
  // m, hand and corners: what counts as there. A tenth of what a motion is allowed.
  static constexpr double kThere = 1e-4;

  // PreconditionError where the body has no effector of that name. The body outlives this.
  IndependentReach(const BodyModel& body, std::string_view effector);

  // (dofs, rad) a posture within all limits that has the effector at the goal (m, world) and the
  // feet where they stand in the start posture: the first that is found from the start posture and
  // `starts` random ones. Nothing: none was found.
  [[nodiscard]] std::optional<std::vector<double>> posture(const Vec3d& goal, int starts,
                                                           Random& random);

 private:
  // a point of a link that is to be at a place (m, world)
  struct Held {
    int link = 0;
    Vec3d point{};  // m, link frame
    Vec3d place{};
  };

  double evaluate(std::span<const double> z, std::span<double> gradient) override;
  void add_limits();
  [[nodiscard]] bool descend(std::span<double> z);

  const BodyModel& body_;
  std::vector<Held> held_;           // the effector first
  std::vector<LinearLimit> limits_;  // of z, the angles less the start's
  std::vector<double> size_;         // (dofs) 1
  std::vector<double> angles_;       // (dofs) rad
  std::vector<double> rows_;         // of the Jacobian at a start
  Kinematics<double> placed_;
  VariableMetric metric_;
};

// (rad) The most that any of the angles (dofs, rad) is outside its range, by the body's own numbers
// and not by the library's measures of them; 0: none is.
[[nodiscard]] double excess_of(const BodyModel& body, std::span<const double> angles);

}  // namespace shigusa::bench
