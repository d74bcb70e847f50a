// SPDX-License-Identifier: MIT
#include "human_frames.hpp"

#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"

namespace shigusa {
namespace {

// Bend below which a limb's own hinge axis is ignored, and above which it is used alone.
constexpr double kBendIgnored = radians(5.0);
constexpr double kBendTrusted = radians(20.0);
// Cosine of the largest angle between a bend's axis and the expected one, beyond which the joint is
// hyperextended: a knee's axis follows its foot, an arm turns by some 120° at most.
constexpr double kKneeTurns = 0.0;
constexpr double kElbowTurns = -0.5;
// Sine of the angle between shank and foot, about the trunk's left, below which the foot is ignored
// for the knee's axis, and above which it is used alone: a hanging foot points along the shank.
constexpr double kFootIgnored = 0.2;
constexpr double kFootTrusted = 0.5;

// Frame with x exactly along `x` and y as near to `y` as possible.
Mat3d frame_x_y(const Vec3d& x, const Vec3d& y) {
  const Vec3d ex = normalized(x, {1, 0, 0});
  const Vec3d ez = normalized(cross(ex, y), {0, 0, 1});
  return {ex, cross(ez, ex), ez};
}

double share(double value, double from, double to) {
  return clamp((value - from) / (to - from), 0.0, 1.0);
}

// Hinge axis of a bent limb, blended between the axis of its two segments if they are bent enough
// and the expected one. `bent`: cross product of the segments, in the direction of the axis when
// flexed; `turns`: least cosine between the two axes.
Vec3d hinge_axis(const Vec3d& bent, const Vec3d& expected, double turns) {
  const double sine = norm(bent);
  const double trust =
      dot(bent, expected) > turns * sine ? share(asin(sine), kBendIgnored, kBendTrusted) : 0.0;
  return normalized(normalized(bent, expected) * trust + expected * (1.0 - trust), expected);
}

// Axis of a straight knee: perpendicular to shank and foot. With a foot along the shank, in either
// direction, it is the trunk's left, made perpendicular to the shank.
Vec3d knee_axis(const Vec3d& up, const Vec3d& ahead, const Vec3d& trunk_left) {
  const Vec3d across = cross(up, ahead);
  const double sine = dot(across, trunk_left) / max(norm(ahead), 1e-9);
  const Vec3d left = normalized(trunk_left - up * dot(up, trunk_left), trunk_left);
  const Vec3d by_foot = normalized(across, left);
  const double trust = share(sine, kFootIgnored, kFootTrusted);
  return trust < 1.0 ? normalized(by_foot * trust + left * (1.0 - trust), left) : by_foot;
}

Mat3d trunk_frame(const Landmarks& p) {
  const Vec3d up = p.left_arm.shoulder + p.right_arm.shoulder - p.left_leg.hip - p.right_leg.hip;
  const Vec3d left = p.left_arm.shoulder - p.right_arm.shoulder + p.left_leg.hip - p.right_leg.hip;
  const Vec3d y = normalized(up);
  const Vec3d z = normalized(cross(left, y), {0, 0, 1});
  const Mat3d along{cross(y, z), y, z};
  return p.trunk_lean == 0.0 ? along : along * rotation(Axis::x, p.trunk_lean);
}

LegFrames leg_frames(const Landmarks::Leg& leg, const Vec3d& trunk_left, bool lifted) {
  const Vec3d thigh_down = normalized(leg.knee - leg.hip);
  const Vec3d shank_down = normalized(leg.ankle - leg.knee);
  const Vec3d up = lifted ? -shank_down : normalized(leg.hip - leg.ankle);
  Vec3d ahead = leg.toe - leg.ankle;
  if (!lifted) ahead.y = 0.0;
  const Vec3d expected = knee_axis(up, ahead, trunk_left);
  const Vec3d axis = hinge_axis(cross(thigh_down, shank_down), expected, kKneeTurns);
  LegFrames frames{frame_x_y(axis, -thigh_down), frame_x_y(axis, -shank_down), {}};
  if (lifted) {
    // the slope of the line from ankle to toe tip is that of a standing foot
    using F = StatureFractions;
    const double slope = atan2(F::kAnkleHeight, (1.0 - kHeelShare) * F::kFootLength);
    frames.foot = rotated(frame_x_y(axis, cross(ahead, axis)), Axis::x, sin_cos(-slope));
  } else {
    frames.foot = frame_x_y(axis, {0, 1, 0});
  }
  return frames;
}

ArmFrames arm_frames(const Landmarks::Arm& arm, const Mat3d& trunk) {
  const Vec3d upper_down = normalized(arm.elbow - arm.shoulder);
  const Vec3d fore_down = normalized(arm.wrist - arm.elbow);
  // a straight arm's hinge axis: the trunk's left, rotated by the shortest swing from hanging
  const Vec3d hanging = -trunk.cy;
  const Vec3d swing = cross(hanging, upper_down);
  const double cosine = dot(hanging, upper_down);
  const Vec3d left = trunk.cx;
  const Vec3d carried =
      cosine < -0.999
          ? left
          : left + cross(swing, left) + cross(swing, cross(swing, left)) * (1.0 / (1.0 + cosine));
  const Vec3d axis =
      hinge_axis(cross(fore_down, upper_down), normalized(carried, left), kElbowTurns);
  return {frame_x_y(axis, -upper_down), frame_x_y(axis, -fore_down)};
}

}  // namespace

HumanFrames human_frames(const Landmarks& person) {
  HumanFrames frames;
  frames.trunk = trunk_frame(person);
  const double floor = min(person.left_leg.ankle.y, person.right_leg.ankle.y);
  const auto leg = [&](const Landmarks::Leg& l) {
    return leg_frames(l, frames.trunk.cx, l.ankle.y - floor > kLiftedFoot);
  };
  frames.left_leg = leg(person.left_leg);
  frames.right_leg = leg(person.right_leg);
  frames.left_arm = arm_frames(person.left_arm, frames.trunk);
  frames.right_arm = arm_frames(person.right_arm, frames.trunk);
  return frames;
}

Mat3d along_segment(const Mat3d& frame, const Vec3d& joint, const Vec3d& far) {
  const Vec3d y = normalized(joint - far, frame.cy);
  const Vec3d z = normalized(cross(frame.cx, y), frame.cz);
  return {cross(y, z), y, z};
}

BallAngles ball_angles(const Mat3d& relative, Side side) {
  const double s = side_sign(side);
  const auto with_flexion = [&](double flexion) {
    const Mat3d rest = rotation(Axis::x, flexion) * relative;
    return BallAngles{flexion, s * atan2(-rest.cy.x, rest.cy.y), s * atan2(-rest.cx.z, rest.cz.z)};
  };
  const double across = sqrt(relative.cy.y * relative.cy.y + relative.cy.z * relative.cy.z);
  // a limb straight out to the side: flexion and rotation share an axis, and rotation is used
  const double flexion = across < 1e-6 ? 0.0 : -atan2(relative.cy.z, relative.cy.y);
  // a limb raised sideways is abducted by more than 90° rather than flexed and rotated
  const BallAngles plain = with_flexion(flexion);
  const BallAngles over = with_flexion(flexion > 0.0 ? flexion - kPi : flexion + kPi);
  const auto size = [](const BallAngles& b) {
    return abs(b.flexion) + abs(b.abduction) + abs(b.rotation);
  };
  return size(over) < size(plain) ? over : plain;
}

double hinge_angle(const Mat3d& a, const Mat3d& b) {
  const Vec3d y = transpose_times(a, b.cy);
  return atan2(y.z, y.y);
}

}  // namespace shigusa
