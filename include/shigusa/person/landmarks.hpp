// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body/body_part.hpp>
#include <shigusa/body/side.hpp>
#include <vector>

namespace shigusa {

// Corners of a sole, counter-clockwise from above: left of the tip, left of the heel, right of the
// heel, right of the tip. m, as the landmarks.
using SoleOutline = std::array<Vec3d, 4>;

// Joint centres and tips of a person in one posture: all that a body's geometry and start posture
// are made of. Metres, in shigusa's world: +Y up, facing +Z, left is +X, origin on the floor
// between the feet.
struct Landmarks {
  // Joints of a leg (m).
  struct Leg {
    Vec3d hip;    // centre of the joint
    Vec3d knee;   // centre of the joint
    Vec3d ankle;  // centre of the joint
    Vec3d toe;    // tip of the foot
    // the toes' joint, of a character that lifts its heels the file's node; see toes_joint
    std::optional<Vec3d> toes{};
    // of a character with a mesh the shoe's, at the height of its lowest point; none: by stature
    std::optional<SoleOutline> sole{};
  };
  // Joints of an arm (m).
  struct Arm {
    Vec3d shoulder;                   // centre of the joint
    Vec3d elbow;                      // centre of the joint
    Vec3d wrist;                      // centre of the joint
    Vec3d fingertip;                  // tip of the third finger
    std::optional<Vec3d> clavicle{};  // its joint with the breastbone; none: part of the trunk
    // where the hand holds things: of a character the node nearest to it; see grip_of
    std::optional<Vec3d> grip{};
  };
  Leg left_leg;    // the person's own left
  Leg right_leg;   // and right
  Arm left_arm;    // the person's own left
  Arm right_arm;   // and right
  Vec3d neck;      // base of the neck (C7)
  Vec3d head_top;  // vertex
  // Joints that the paper's rigid trunk does without; a person from a file may lack some.
  std::vector<Vec3d> spine{};   // 0..kSpineJoints, from below
  std::optional<Vec3d> head{};  // between neck and skull
  PartShapes parts{};  // of a character with a mesh, those that it tells; see body_part.hpp

  // The leg of a side.
  [[nodiscard]] const Leg& leg(Side side) const {
    return side == Side::left ? left_leg : right_leg;
  }
  // The arm of a side.
  [[nodiscard]] const Arm& arm(Side side) const {
    return side == Side::left ? left_arm : right_arm;
  }
};

// The point that an arm's goals are given for: its own grip, or the third knuckle.
[[nodiscard]] Vec3d grip_of(const Landmarks::Arm& arm);

// Where the toes bend: their own joint, or at kToesShare of the way from the ankle to the tip.
[[nodiscard]] Vec3d toes_joint(const Landmarks::Leg& leg);
// Share of the way from the ankle to the tip of the foot at which toes bend.
inline constexpr double kToesShare = 0.7;

// Landmarks of a person standing upright at ease: knees bent by 5°, elbows by 10°, arms hanging,
// each foot turned out by `toe_out` (rad).
[[nodiscard]] Landmarks standing_landmarks(double stature, double toe_out);

}  // namespace shigusa
