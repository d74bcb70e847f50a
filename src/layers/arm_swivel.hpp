// SPDX-License-Identifier: MIT
#pragma once

#include "layers/arm_motion.hpp"
#include "motion/effector_turn.hpp"

namespace shigusa {

// Moves the hand of an arm_body along a path in closed form. The distance from the shoulder gives
// the elbow; of the shoulder's three turns the direction of the hand leaves one, the swivel of the
// elbow about the line u from shoulder to hand. It is counted from where the hand's path takes the
// elbow by itself: the axis of the elbow, square to u, is carried along from frame to frame by the
// shortest turn from one u to the next, then turned about u by swivel · s(t), with s the minimum
// jerk of the motion. So no direction of the hand is singular, hanging arms included, and an elbow
// goes on evenly where its hand does. Where the upper arm points straight sideways, the angles of a
// flexion-abduction-rotation joint turn fast all the same.
//
// A hand that turns has the turn that is wanted of it at the end: forearm and wrist go from their
// start angles to those that give it, with minimum jerk, and in each frame the arm brings the hand
// to its place with the wrist as it is then. The last angles are a fixed point, as the wrist moves
// the hand's place beside the forearm: the arm is placed for a wrist, the wrist is turned to the
// goal, and so on until both agree.
//
// Holds its scratch memory: make one per thread. The arm outlives it.
class SwivelArm {
 public:
  // `limb` is the arm on the whole body.
  SwivelArm(const BodyModel& arm, const BodyLimb& limb);

  // path as ArmRollout::run has it; swivel (rad, positive outwards) is that of the last frame;
  // turn: of the hand, in the path's frame, where the arm has a wrist (kTurningArmDofs). angles:
  // (frames × dofs of the arm) rad, the start posture first. Returns the largest distance of the
  // hand from the path (m): what the path is longer or shorter than the arm can be.
  double run(std::span<const Vec3d> path, double swivel, std::vector<double>& angles,
             const EffectorTurn& turn = {}) const;

 private:
  // Where a hand is from the shoulder and how its elbow is swivelled there: unit vectors.
  struct Line {
    Vec3d along{};          // to the hand
    Vec3d axis{};           // of the elbow, square to it
    double distance = 0.0;  // m
  };
  struct Placed {
    Mat3d upper{};  // of the upper arm in the path's frame
    double bend = 0.0;
    double reach = 0.0;  // m
  };

  [[nodiscard]] std::vector<Line> lines_of(std::span<const Vec3d> path, double swivel) const;
  // the arm with its hand on the line; `bend`: near which the elbow's angle is
  [[nodiscard]] static Placed place(const HingedLimb& segments, const Line& line, double bend);
  // from shoulder to hand with the wrist as q (dofs, rad) has it
  [[nodiscard]] HingedLimb segments_at(std::span<const double> q) const;
  // sets forearm and wrist in q (dofs, rad) to what turns the hand as wanted at the end of the line
  void turn_hand(const EffectorTurn& turn, const Line& line, std::span<double> q) const;
  [[nodiscard]] Mat3d wrist_rotation(std::span<const double> q) const;

  const BodyModel* arm_;
  BodyLimb limb_;    // with the arm's own numbers
  double outwards_;  // +1 or -1: the turn about u that lifts the elbow outwards
};

}  // namespace shigusa
