// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// A named change of posture as a direction in joint space: a motion is attracted to start + Σ value
// · direction, from a bent start to standing + Σ value · direction (ReachProblem::rise), as far as
// its goals and planted feet permit.
struct PostureMode {
  std::string name;               // "squat"
  std::string_view sentence;      // description of its effect
  std::vector<double> direction;  // (dofs) rad per unit of the value
  double lower = 0.0;             // rad, range of useful values
  double upper = 0.0;             // rad
};

// Bend of each hip and ankle in a squat, as a share of the knee's angle.
inline constexpr double kOfKnee = 0.5;

// Number of the back's joints that bend, from below.
[[nodiscard]] std::size_t back_joints(const BodyModel& body);

// Modes of a body, as far as it has the degrees of freedom: squat, lean, round, twist, and for each
// arm elbow, swivel and wrist. Reason for the choice: weights alone never find a squat, since from
// a nearly straight knee lowering the hand begins with extending it; targets for knee, trunk and
// swivel improved the fit to a recorded man most (docs/architecture.md, decision 13).
[[nodiscard]] std::vector<PostureMode> posture_modes(const BodyModel& body);

}  // namespace shigusa
