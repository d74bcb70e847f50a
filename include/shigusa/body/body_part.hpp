// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/math/vec3.hpp>
#include <string_view>

namespace shigusa {

// The parts of a person that nothing should pass through. A trunk is one part, or pelvis, spine,
// chest and upper chest where it has joints: a body has the one or the others.
enum class BodyPart {
  head,  // the skull without its lower part
  jaw,   // the lower part of the skull
  neck,
  trunk,
  pelvis,
  spine,
  chest,
  upper_chest,
  left_thigh,
  right_thigh,
  left_shank,
  right_shank,
  left_foot,
  right_foot,
  left_upper_arm,
  right_upper_arm,
  left_forearm,
  right_forearm,
  left_hand,
  right_hand,
};
// Number of the parts.
inline constexpr int kBodyPartCount = 20;

// "left_upper_arm".
[[nodiscard]] std::string_view body_part_name(BodyPart part);

// A line with a thickness, in the part's own frame: its origin is the joint that the part hangs on
// (of the trunk and its pieces between the hips), y points from its far end to that joint, z ahead,
// x to the left; of head, neck and trunk these are the trunk's axes, and a foot's y is up where it
// stands.
struct PartShape {
  Vec3d from{};         // m
  Vec3d to{};           // m
  double radius = 0.0;  // m, > 0
};

// (parts) shapes, as far as they are known.
struct PartShapes {
  std::array<std::optional<PartShape>, kBodyPartCount> shape{};  // by the number of the part

  // The shape of a part, or nothing.
  [[nodiscard]] const std::optional<PartShape>& operator[](BodyPart part) const {
    return shape[static_cast<std::size_t>(part)];
  }
  // The same, to be changed.
  [[nodiscard]] std::optional<PartShape>& operator[](BodyPart part) {
    return shape[static_cast<std::size_t>(part)];
  }
};

}  // namespace shigusa
