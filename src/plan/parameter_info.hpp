// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/parameters.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// The facts about all parameters of one kind.
struct ParameterKindInfo {
  ParameterKind kind;
  std::string_view word;  // after the name, "weight" of "right_hip.flexion.weight"; may be empty
  std::string_view of;    // what has such a parameter
  bool angle;             // in radians; people write it in degrees too
  bool of_freedom;        // its name is a freedom's, and the joint's name means all of the joint
  std::string_view sentence;
  double low{};  // what is allowed, where a parameter says nothing else
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

// A parameter with all that follows from its kind and its name.
[[nodiscard]] ParameterInfo parameter_info(ParameterKind kind, std::string name,
                                           std::vector<int> applies_to);
// The same with another range.
[[nodiscard]] ParameterInfo within(ParameterInfo info, double least, double most);

}  // namespace shigusa
