// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "rollout/reach_problem.hpp"

namespace shigusa {

struct ReachabilitySettings {
  int starts = 48;       // initial postures of the search: the start posture and random ones
  int iterations = 400;  // largest number of steps from each
  int other = 0;         // 1, 2, …: other random postures, without the start posture
};

// The body's nearest posture to its goals that it can move to from its start posture with the feet
// planted, whatever the path.
struct ClosestReach {
  std::vector<double> angles;    // (dofs) rad
  std::vector<Vec3d> positions;  // m, world: positions of the effectors
  std::vector<Mat3d> turns;      // orientations of the effectors, R_WL
  // m, the root of the summed squared distances to the goals or their boxes; turns count by
  // kTurnLength
  double distance = 0.0;

  [[nodiscard]] bool reached(double tolerance = kReachTolerance) const {
    return distance <= tolerance;
  }
};

// Searches the posture with the effectors nearest to their paths' ends, by damped Gauss-Newton
// steps of weighted IK with the planted feet as exact constraints, from several postures. Joint
// limits hold if the problem holds them (the paper's IK ignores them). It stops early at a goal
// that is met; among postures whose distances differ by less than 5 mm, none meeting the goal, it
// takes the one nearest to the start posture's own descent. Heels that can lift do so if the
// effectors miss their goals with flat feet. Deterministic.
[[nodiscard]] ClosestReach closest_reach(const ReachProblem& problem,
                                         const ReachabilitySettings& settings = {});

// Moves the goals of a problem back towards the effectors' start positions if a limb penetrates the
// rest of the body in the nearest posture, `reach`, beyond the flesh's compliance, the depth at the
// start and kDetourDepth: as far along, in tenths, as the limb is clear. The same problem if the
// posture is clear, or no such goal is.
[[nodiscard]] ReachProblem clear_goals(const ReachProblem& problem, const ClosestReach& reach);

}  // namespace shigusa
