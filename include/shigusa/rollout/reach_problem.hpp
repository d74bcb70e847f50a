// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <shigusa/kinematics/weighted_ik.hpp>
#include <shigusa/motion/minimum_jerk.hpp>
#include <vector>

namespace shigusa {

inline constexpr int kMotionSteps = 60;          // IK steps per motion (rule R6)
inline constexpr double kReachTolerance = 1e-3;  // m: what counts as met, of goals and planted feet
inline constexpr double kTiltTolerance = radians(0.1);  // rad: what a planted foot may turn

// One effector with its way to the goal.
struct ReachGoal {
  int effector = 0;  // index in the body's effectors
  EffectorPath path;
};

// Everything that is the same for all motions of one search.
struct ReachProblem {
  const BodyModel* body = nullptr;  // outlives the problem
  std::vector<ReachGoal> goals;
  double duration = 1.0;  // s
  int steps = kMotionSteps;
  // (dofs, rad) or empty: a posture that the null space is drawn to and the motion ends near; for
  // goals that a straight path alone does not lead to, such as the very edge of reach
  std::vector<double> guide;
  // false: the hands go where the guide takes them, and only the last frame has them at their goals
  bool follow_path = true;
  IkSettings ik;
  // after each step, corrections follow until all targets are this near, or their number is used up
  double path_tolerance = 1e-6;  // m
  int corrections = 3;
  // the last frame has the hand at rest: there the goal itself is to be met
  double goal_tolerance = 1e-6;  // m
  int goal_corrections = 12;
  // where a planted foot is off by more than this after all, up to so many steps correct it alone
  double contact_slack = 1e-4;  // m
  int contact_corrections = 8;
};

// What a motion must keep whatever its score: met goals, effectors on their paths, planted feet.
struct ReachOutcome {
  double goal_error = 0.0;     // m, largest distance of an effector from its path's end
  double path_error = 0.0;     // m, largest distance from the path at any frame that follows it
  double contact_slide = 0.0;  // m, largest displacement of a planted foot at any frame
  double contact_tilt = 0.0;   // rad, largest rotation of a planted foot at any frame

  // The planted feet stay where they are.
  [[nodiscard]] bool stands() const {
    return contact_slide <= kReachTolerance && contact_tilt <= kTiltTolerance;
  }
  [[nodiscard]] bool met(double tolerance = kReachTolerance) const {
    return goal_error <= tolerance && path_error <= tolerance && stands();
  }
};

// The targets of weighted IK for a problem: its goals, then each planted foot but the base, held
// where it stands in the start posture.
[[nodiscard]] std::vector<IkTarget<double>> ik_targets(const ReachProblem& problem);

}  // namespace shigusa
