// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/parameters.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// The meaning of a parameter's number.
enum class ParameterKind {
  weight,       // of one freedom in weighted IK; a lock keeps the freedom at its start angle
  contraction,  // how much shorter limbs end: 0..kContractionMax parts of their range
  swivel,       // rad, how far the elbow ends from where the arm's path alone takes it, outwards
  final_angle,  // rad, that one freedom ends at
  mode,         // rad, the value of a posture mode
  timing,       // a number of Timing
  support,      // share of the body's weight that a resting hand presses with
};

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

// One number that a search or a person sets. Whatever assigns, fixes, mirrors, stores, shows or
// searches parameters goes by a plan's list of these.
struct ParameterInfo {
  std::string name;  // "right_hip.flexion", "legs", "right_arm", "squat"
  ParameterKind kind = ParameterKind::weight;
  // Of the layer's body: the freedom with that weight or final angle; the freedoms that turn the
  // elbow; limbs that share a contraction. Of the posture: the number of the mode or timing.
  std::vector<int> applies_to{};
  double low = 0.0;  // what is allowed
  double high = 0.0;
  double shown_low = 0.0;  // what makes sense
  double shown_high = 0.0;
  std::string group{};  // whose it is: "right_leg", "arms", "trunk", "posture", "path"
  std::string_view sentence{};

  // A parameter with all that follows from its kind and its name.
  [[nodiscard]] static ParameterInfo named(ParameterKind kind, std::string name,
                                           std::vector<int> applies_to);
  [[nodiscard]] ParameterInfo within(double least, double most) &&;
};

}  // namespace shigusa
