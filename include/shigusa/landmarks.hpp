// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body_model.hpp>
#include <shigusa/vec3.hpp>
#include <string_view>
#include <vector>

namespace shigusa {

/// The parts of a person that nothing should pass through. A trunk is one part, or pelvis, spine,
/// chest and upper chest where it has joints: a body has the one or the others.
enum class BodyPart {
  head,             ///< the skull without its lower part
  jaw,              ///< the lower part of the skull
  neck,             ///< between upper chest and head
  trunk,            ///< from hips to neck, of a body without a spine
  pelvis,           ///< about the hips
  spine,            ///< the waist
  chest,            ///< the lower ribs
  upper_chest,      ///< the upper ribs and the shoulders
  left_thigh,       ///< hip to knee
  right_thigh,      ///< hip to knee
  left_shank,       ///< knee to ankle
  right_shank,      ///< knee to ankle
  left_foot,        ///< heel to toes
  right_foot,       ///< heel to toes
  left_upper_arm,   ///< shoulder to elbow
  right_upper_arm,  ///< shoulder to elbow
  left_forearm,     ///< elbow to wrist
  right_forearm,    ///< elbow to wrist
  left_hand,        ///< wrist to fingertips
  right_hand,       ///< wrist to fingertips
};
/// Number of the parts.
inline constexpr int kBodyPartCount = 20;

/// "left_upper_arm".
[[nodiscard]] std::string_view body_part_name(BodyPart part);

/// A line with a thickness, in the part's own frame: its origin is the joint that the part hangs on
/// (of the trunk and its pieces between the hips), y points from its far end to that joint, z
/// ahead, x to the left; of head, neck and trunk these are the trunk's axes, and a foot's y is up
/// where it stands. A flat part is two such lines side by side.
struct PartShape {
  Vec3d from{};               ///< m
  Vec3d to{};                 ///< m
  double radius = 0.0;        ///< m, > 0, at `from`
  double to_radius = radius;  ///< m, > 0, at `to`; between them it changes evenly
  Vec3d aside{};              ///< m: of a flat part, from the middle to either line
};

/// (parts) shapes, as far as they are known.
struct PartShapes {
  std::array<std::optional<PartShape>, kBodyPartCount> shape{};  ///< by the number of the part

  /// The shape of a part, or nothing.
  [[nodiscard]] const std::optional<PartShape>& operator[](BodyPart part) const {
    return shape[static_cast<std::size_t>(part)];
  }
  /// The same, to be changed.
  [[nodiscard]] std::optional<PartShape>& operator[](BodyPart part) {
    return shape[static_cast<std::size_t>(part)];
  }
};

/// Corners of a sole, counter-clockwise from above: left of the tip, left of the heel, right of the
/// heel, right of the tip. m, as the landmarks.
using SoleOutline = std::array<Vec3d, 4>;

/// Joint centres and tips of a person in one posture: all that a body's geometry and start posture
/// are made of. Metres, in shigusa's world: +Y up, facing +Z, left is +X, origin on the floor
/// between the feet.
struct Landmarks {
  /// Joints of a leg (m).
  struct Leg {
    Vec3d hip;    ///< centre of the joint
    Vec3d knee;   ///< centre of the joint
    Vec3d ankle;  ///< centre of the joint
    Vec3d toe;    ///< tip of the foot
    /// the toes' joint, of a character that lifts its heels the file's node; see toes_joint
    std::optional<Vec3d> toes{};
    /// of a character with a mesh the shoe's, at the height of its lowest point; none: by stature
    std::optional<SoleOutline> sole{};
  };
  /// Joints of an arm (m).
  struct Arm {
    Vec3d shoulder;                   ///< centre of the joint
    Vec3d elbow;                      ///< centre of the joint
    Vec3d wrist;                      ///< centre of the joint
    Vec3d fingertip;                  ///< tip of the third finger
    std::optional<Vec3d> clavicle{};  ///< its joint with the breastbone; none: part of the trunk
    /// where the hand holds things: of a character the node nearest to it; see grip_of
    std::optional<Vec3d> grip{};
  };
  Leg left_leg;    ///< the person's own left
  Leg right_leg;   ///< and right
  Arm left_arm;    ///< the person's own left
  Arm right_arm;   ///< and right
  Vec3d neck;      ///< base of the neck (C7)
  Vec3d head_top;  ///< vertex
  /// Joints that the paper's rigid trunk does without; a person from a file may lack some.
  std::vector<Vec3d> spine{};   ///< 0..3, from below
  std::optional<Vec3d> head{};  ///< between neck and skull
  /// rad: how far back the line from the hips to the shoulders leans of a trunk that is upright
  double trunk_lean = 0.0;
  PartShapes parts{};  ///< of a character with a mesh, those that it tells

  /// The leg of a side.
  [[nodiscard]] const Leg& leg(Side side) const {
    return side == Side::left ? left_leg : right_leg;
  }
  /// The same, to be changed.
  [[nodiscard]] Leg& leg(Side side) { return side == Side::left ? left_leg : right_leg; }
  /// The arm of a side.
  [[nodiscard]] const Arm& arm(Side side) const {
    return side == Side::left ? left_arm : right_arm;
  }
  /// The same, to be changed.
  [[nodiscard]] Arm& arm(Side side) { return side == Side::left ? left_arm : right_arm; }
};

/// The point that an arm's goals are given for: its own grip, or the third knuckle.
[[nodiscard]] Vec3d grip_of(const Landmarks::Arm& arm);

/// Where the toes bend: their own joint, or at kToesShare of the way from the ankle to the tip.
[[nodiscard]] Vec3d toes_joint(const Landmarks::Leg& leg);
/// Share of the way from the ankle to the tip of the foot at which toes bend.
inline constexpr double kToesShare = 0.7;

/// Landmarks of a person standing upright at ease: knees bent by 5°, elbows by 10°, arms hanging,
/// each foot turned out by `toe_out` (rad).
[[nodiscard]] Landmarks standing_landmarks(double stature, double toe_out);

}  // namespace shigusa
