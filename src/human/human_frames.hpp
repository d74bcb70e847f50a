// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/human.hpp>

namespace shigusa {

// +1 for the left side, -1 for the right: the sign of abduction and lateral rotation.
[[nodiscard]] constexpr double side_sign(Side side) { return side == Side::left ? 1.0 : -1.0; }

// Segment frames (R_WL) of a person in one posture: y along the segment upwards, x to the left
// along the hinge axis, z forwards; all equal when every anatomical angle is 0.
struct LegFrames {
  Mat3d thigh;
  Mat3d shank;
  Mat3d foot;
};
struct ArmFrames {
  Mat3d upper_arm;
  Mat3d forearm;
};
struct HumanFrames {
  Mat3d trunk;
  LegFrames left_leg;
  LegFrames right_leg;
  ArmFrames left_arm;
  ArmFrames right_arm;

  [[nodiscard]] const LegFrames& leg(Side s) const {
    return s == Side::left ? left_leg : right_leg;
  }
  [[nodiscard]] const ArmFrames& arm(Side s) const {
    return s == Side::left ? left_arm : right_arm;
  }
};

[[nodiscard]] HumanFrames human_frames(const Landmarks& person);

// Segment frame with y exactly along the segment, from its far joint to its near joint, and x as
// near as possible to that of the anatomical frame. It maps the far joint of one posture to that of
// another, whatever the shape of the limb.
[[nodiscard]] Mat3d along_segment(const Mat3d& frame, const Vec3d& joint, const Vec3d& far);

// Flexion, abduction and lateral rotation (rad) of a ball joint: R = Rx(-flexion) · Rz(side ·
// abduction) · Ry(side · rotation). Of the two solutions the one with the smaller angles.
struct BallAngles {
  double flexion = 0.0;
  double abduction = 0.0;
  double rotation = 0.0;
};
[[nodiscard]] BallAngles ball_angles(const Mat3d& relative, Side side);

// Angle (rad) from a to b about their common x axis.
[[nodiscard]] double hinge_angle(const Mat3d& a, const Mat3d& b);

}  // namespace shigusa
