// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body_model.hpp>
#include <string>
#include <string_view>

namespace shigusa {

// The limb that a joint is of.
enum class LimbKind { trunk, arm, leg };

// The parts of the name of a joint, freedom or effector: "left_hip.flexion" is the freedom
// "flexion" of the joint "hip" on the left.
struct JointName {
  std::optional<Side> side{};  // none of the trunk, and of what both sides share
  std::string_view joint;      // "hip", "upper_chest", "hand"
  std::string_view freedom{};  // "flexion"; empty of a joint or an effector

  [[nodiscard]] LimbKind limb() const;
};

// The parts look into `name`.
[[nodiscard]] JointName parse_joint_name(std::string_view name);

// "hip.flexion" of "left_hip.flexion"; a name without a side as it is.
[[nodiscard]] std::string_view without_side(std::string_view name);

// "right_hip.flexion" of "left_hip.flexion"; a name without a side as it is.
[[nodiscard]] std::string with_other_side(std::string_view name);

}  // namespace shigusa
