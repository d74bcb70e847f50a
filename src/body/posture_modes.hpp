// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// A change of posture that people have a word for, as a direction in the joint angles: a motion is
// drawn to start + Σ value · direction, as far as its goals and planted feet let it.
struct PostureMode {
  std::string name;               // "squat"
  std::string_view sentence;      // what it does
  std::vector<double> direction;  // (dofs) rad per unit of the value
  double lower = 0.0;             // rad, of the values that make sense
  double upper = 0.0;             // rad
};

// In a squat each hip and ankle bends by this share of the knee's angle.
inline constexpr double kOfKnee = 0.5;

// The modes of a body, as far as it has the freedoms: squat, lean, round, twist, and of each arm
// elbow, swivel and wrist.
// Source of the choice: weights alone never find a squat, since for a nearly straight knee lowering
// the hand begins with extending it; references for knee, trunk and swivel did most for the fit to
// a recorded man (docs/architecture.md, decision 13).
[[nodiscard]] std::vector<PostureMode> posture_modes(const BodyModel& body);

}  // namespace shigusa
