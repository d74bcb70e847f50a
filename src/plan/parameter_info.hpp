// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/parameters.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// Common data of all parameters of one kind.
struct ParameterKindInfo {
  ParameterKind kind;
  std::string_view word;  // suffix, "weight" in "right_hip.flexion.weight"; may be empty
  std::string_view of;    // kind of object with such a parameter
  bool angle;             // in radians; users may write degrees
  bool of_freedom;  // its name is a dof's, and the joint's name stands for all dofs of the joint
  std::string_view sentence;
  double low{};  // default range of a parameter
  double high{};
};
inline constexpr std::array kParameterKinds{
    ParameterKindInfo{ParameterKind::weight, "weight", "joint", false, true,
                      "The larger the weight, the less the freedom moves beside the others.",
                      kWeightMin, kWeightMax},
    ParameterKindInfo{ParameterKind::contraction, "contraction", "limb", false, false,
                      "The limb ends shorter by this many of 15 parts of its range.", 0.0,
                      kContractionMax},
    ParameterKindInfo{ParameterKind::swivel, "swivel", "arm", true, false,
                      "The elbow ends turned outwards about the line from shoulder to hand."},
    ParameterKindInfo{ParameterKind::final_angle, "final", "joint", true, true,
                      "The freedom ends at this angle."},
    ParameterKindInfo{ParameterKind::mode, "", "posture", true, false, "", -kPostureMax,
                      kPostureMax},
    ParameterKindInfo{ParameterKind::timing, "", "posture", false, false, ""},
    ParameterKindInfo{ParameterKind::support, "support", "resting hand", false, false,
                      "The hand presses on its place with this share of the body's weight; below 0 "
                      "it stays free.",
                      kSupportLeast, kSupportMost},
};
[[nodiscard]] constexpr const ParameterKindInfo& info_of(ParameterKind kind) {
  return kParameterKinds[static_cast<std::size_t>(kind)];
}

// A parameter with the properties of its kind and its name.
[[nodiscard]] ParameterInfo parameter_info(ParameterKind kind, std::string name,
                                           std::vector<int> applies_to);
// The same parameter with another range.
[[nodiscard]] ParameterInfo within(ParameterInfo info, double least, double most);

}  // namespace shigusa
