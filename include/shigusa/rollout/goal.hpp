// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/math/quat.hpp>
#include <shigusa/math/vec3.hpp>
#include <string>

namespace shigusa {

// An axis of an effector and where it is to point. The effector's frame is the world's where the
// body stands with every angle at 0, facing +Z, arms hanging with the thumbs ahead: of a hand
// fingers point to -y, the thumb's side is +z, and the palm faces the body, +x of the right one.
struct GoalAxis {
  Vec3d axis{0, 0, 1};       // in the effector's frame; of any length but 0
  Vec3d direction{0, 1, 0};  // in the world; of any length but 0
  friend bool operator==(const GoalAxis&, const GoalAxis&) = default;
};

// The final state of one effector.
struct Goal {
  std::string effector = "right_hand";  // see BodyModel::find_effector
  Vec3d position{};                     // m, shigusa's world
  double load = 0.0;                    // kg, 0..kLoadMax, held all the way
  // How it is turned from the world's axes to its frame (see GoalAxis), a unit quaternion to within
  // kUnitSlack; or one axis, about which it may turn. At most one of both.
  std::optional<Quatd> rotation{};
  std::optional<GoalAxis> axis{};  // the one axis
  Vec3d tolerance{};  // m, ≥ 0: half the sides of the box about `position` where any place will do
  friend bool operator==(const Goal&, const Goal&) = default;
};
inline constexpr double kUnitSlack = 1e-3;     // of a quaternion's squared length
inline constexpr double kToleranceMax = 10.0;  // m

}  // namespace shigusa
