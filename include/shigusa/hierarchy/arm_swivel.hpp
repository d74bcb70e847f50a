// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/hierarchy/arm_motion.hpp>

namespace shigusa {

// Moves the hand of an arm_body along a path in closed form. The distance from the shoulder gives
// the elbow; of the shoulder's three turns the direction of the hand leaves one, the swivel of the
// elbow about the line u from shoulder to hand. It is counted from where the arm's way takes the
// elbow by itself: the axis of the elbow, square to u, is carried along from frame to frame by the
// shortest turn from one u to the next, then turned about u by swivel · s(t), with s the minimum
// jerk of the motion. So no direction of the hand is singular, hanging arms included, and an elbow
// goes on evenly where its hand does. Where the upper arm points straight sideways, the angles of a
// flexion-abduction-rotation joint turn fast all the same.
// Holds its scratch memory: make one per thread. The arm outlives it.
class SwivelArm {
 public:
  // `limb` is the arm on the whole body.
  SwivelArm(const BodyModel& arm, const BodyLimb& limb);

  // path and angles as ArmRollout::run has them; swivel (rad, positive outwards) is that of the
  // last frame. Returns the largest distance of the hand from the path (m): what the path is longer
  // or shorter than the arm can be.
  double run(std::span<const Vec3d> path, double swivel, std::vector<double>& angles) const;

 private:
  // the hand in the upper arm's frame
  [[nodiscard]] Vec3d hand_at(double bend) const;

  const BodyModel* arm_;
  BodyLimb limb_;    // with the arm's own numbers
  double outwards_;  // +1 or -1: the turn about u that lifts the elbow outwards
};

}  // namespace shigusa
