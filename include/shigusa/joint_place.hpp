// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/words.hpp>
#include <string>
#include <string_view>

namespace shigusa {

/// A side of the body, as the person has it.
enum class Side {
  left,   ///< the person's left, +X
  right,  ///< the person's right, -X
};

/// The limb that a joint is of.
enum class LimbKind {
  trunk,  ///< pelvis, spine, neck and head
  arm,    ///< from the clavicle to the hand
  leg,    ///< from the hip to the toes
};

/// A joint of a person, or a place that goals are given for.
enum class JointKind {
  other,        ///< that people have no word for, as robots have some
  hips,         ///< the pelvis
  spine,        ///< the lowest joint of the back
  chest,        ///< the joint above it
  upper_chest,  ///< the joint above that
  neck,         ///< above the shoulders
  head,         ///< of neck and skull
  clavicle,     ///< at the breastbone
  shoulder,     ///< carries the arm
  elbow,        ///< bends the arm
  wrist,        ///< carries the hand
  hand,         ///< its grip, an effector
  hip,          ///< carries the leg
  knee,         ///< bends the leg
  ankle,        ///< carries the foot
  toes,         ///< bend where a heel lifts
  foot,         ///< its sole, an effector
};
/// The words of JointKind.
template <>
inline constexpr std::array kEnumWords<JointKind>{
    EnumWord{JointKind::hips, "hips"},         EnumWord{JointKind::spine, "spine"},
    EnumWord{JointKind::chest, "chest"},       EnumWord{JointKind::upper_chest, "upper_chest"},
    EnumWord{JointKind::neck, "neck"},         EnumWord{JointKind::head, "head"},
    EnumWord{JointKind::clavicle, "clavicle"}, EnumWord{JointKind::shoulder, "shoulder"},
    EnumWord{JointKind::elbow, "elbow"},       EnumWord{JointKind::wrist, "wrist"},
    EnumWord{JointKind::hand, "hand"},         EnumWord{JointKind::hip, "hip"},
    EnumWord{JointKind::knee, "knee"},         EnumWord{JointKind::ankle, "ankle"},
    EnumWord{JointKind::toes, "toes"},         EnumWord{JointKind::foot, "foot"}};
/// The joints of the back, from below.
inline constexpr std::array kBackJoints{JointKind::spine, JointKind::chest, JointKind::upper_chest};

/// The movement that a freedom of a joint is.
enum class FreedomKind {
  other,        ///< that people have no word for; also of an effector, which has none
  flexion,      ///< bends
  abduction,    ///< takes a limb off the body
  lateral,      ///< bends the trunk to the side
  rotation,     ///< turns about the segment's own axis
  inversion,    ///< turns the sole inwards
  elevation,    ///< lifts the shoulder
  protraction,  ///< takes the shoulder forwards
  deviation,    ///< bends the hand sideways
};
/// The words of FreedomKind.
template <>
inline constexpr std::array kEnumWords<FreedomKind>{
    EnumWord{FreedomKind::flexion, "flexion"},
    EnumWord{FreedomKind::abduction, "abduction"},
    EnumWord{FreedomKind::lateral, "lateral"},
    EnumWord{FreedomKind::rotation, "rotation"},
    EnumWord{FreedomKind::inversion, "inversion"},
    EnumWord{FreedomKind::elevation, "elevation"},
    EnumWord{FreedomKind::protraction, "protraction"},
    EnumWord{FreedomKind::deviation, "deviation"}};

/// Where a freedom or an effector is on a person: "left_hip.flexion" is the freedom "flexion" of
/// the joint "hip" of the left leg.
struct JointPlace {
  std::optional<Side> side{};               ///< none of the trunk, and of what both sides share
  LimbKind limb = LimbKind::trunk;          ///< that it is of
  JointKind joint_kind = JointKind::other;  ///< of `joint`
  FreedomKind freedom_kind = FreedomKind::other;  ///< of `freedom`
  std::string joint{};                            ///< "hip", "upper_chest", "hand"
  std::string freedom{};                          ///< "flexion"; empty of an effector

  /// Whether it is that freedom of that joint, of any side.
  [[nodiscard]] bool is(JointKind a_joint, FreedomKind a_freedom) const {
    return joint_kind == a_joint && freedom_kind == a_freedom;
  }
};

/// The place that the name of a joint, freedom, node or effector tells: "left_hip.flexion".
[[nodiscard]] JointPlace parse_joint_name(std::string_view name);

}  // namespace shigusa
