// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/mat3.hpp>

namespace shigusa {

// Two segments with a hinge between them, in closed form: thigh and shank, upper arm and forearm.
// The hinge turns about x. In the first segment's frame the far end is at
//   end(bend) = first + Rx(sign · bend) · second,
// whose x never changes; what is left is a triangle in the y-z plane (law of cosines).
class HingedLimb {
 public:
  // first, second (m): from joint to joint, each in its own segment's frame; both are off the x
  // axis. sign is that of the hinge's dof: +1 where a positive angle turns about +x.
  HingedLimb(const Vec3d& first, const Vec3d& second, double sign);

  // m, of the far end from the near one along x.
  [[nodiscard]] double across() const { return across_; }
  // m, from end to end in the plane of the hinge.
  [[nodiscard]] double length(double bend) const;
  // The bend (rad, in 0..π where the segments have no offset) at which the limb has that length in
  // the plane. A length that no bend gives is held to the nearest one that a bend gives.
  [[nodiscard]] double bend(double length) const;
  // Angle (rad, about x, 0 along +y) of the line from end to end in the first segment's frame.
  [[nodiscard]] double direction(double bend) const;
  // m, lengths that some bend gives.
  [[nodiscard]] double shortest() const { return abs(near_ - far_); }
  [[nodiscard]] double longest() const { return near_ + far_; }

 private:
  double near_;       // m, the first segment's length in the plane
  double far_;        // m, the second one's
  double across_;     // m
  double sign_;       // of the hinge
  double near_turn_;  // rad, about x: the first segment's direction in its own frame …
  double far_turn_;   // … and the second one's in its own
};

// The turn about z (rad) that brings a plane of that x, square to it, through the point `far` of
// positive y: how an ankle inverts for a leg's plane to go through the hip. Nearer to the z axis
// than `across`, the plane gets as near as it can.
[[nodiscard]] double plane_turn(const Vec3d& far, double across);

// Angles of the ball joints of a body, whose relative rotation is R = Rx(x) · Rz(z) · Ry(y): from
// the piece that carries, to the limb (or its transpose, where the limb carries the trunk).
struct BallTurns {
  double x = 0.0;  // rad
  double z = 0.0;
  double y = 0.0;
};

[[nodiscard]] Mat3d ball_rotation(const BallTurns& turns);

// The turns that make the rotation R, of all ways to write it the one whose angles are nearest to
// `near`: so a moving joint's angles do not jump. Where z is 90° to within 1e-9 rad, x and y turn
// about one line; then x is near.x.
[[nodiscard]] BallTurns ball_turns(const Mat3d& rotation, const BallTurns& near = {});

// angle + 2 π k, the nearest to `near` (rad); |angle - near| below 1e6.
[[nodiscard]] double unwrapped(double angle, double near);

// Rule R4: where a pelvis may be, by the limits of ankle and knee. The line from ankle to hip, in
// the plane of the leg, has a lean (rad, about the ankle's axis, forwards) and a length (m).
class PelvisRange {
 public:
  struct Limits {
    double ankle_lower;  // rad
    double ankle_upper;
    double knee_lower;
    double knee_upper;
  };
  // `leg` goes up from the ankle: shank, then thigh; its direction leans back as the knee bends.
  PelvisRange(const HingedLimb& leg, const Limits& limits);

  // m, at the knee's two limits.
  [[nodiscard]] double shortest() const { return shortest_; }
  [[nodiscard]] double longest() const { return longest_; }
  // How far ankle or knee would pass its limit (rad, the larger; 0 within) with that lean and
  // length. A leg that is stretched beyond its length counts by the angle whose tangent the gap is
  // of that length.
  [[nodiscard]] double excess(double lean, double length) const;

 private:
  HingedLimb leg_;
  Limits limits_;
  double shortest_;
  double longest_;
};

}  // namespace shigusa
