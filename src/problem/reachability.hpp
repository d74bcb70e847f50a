// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "rollout/reach_problem.hpp"

namespace shigusa {

struct ReachabilitySettings {
  int starts = 48;       // postures to search from: the start posture and random ones
  int iterations = 400;  // steps from each, at most
  int other = 0;         // 1, 2, …: from other random postures, and not from the start posture
};

// The nearest that a body can come to its goals from its start posture without ever moving its
// planted feet, whatever the path.
struct ClosestReach {
  std::vector<double> angles;    // (dofs) rad
  std::vector<Vec3d> positions;  // (goals) m, world: where the effectors are then …
  std::vector<Mat3d> turns;      // … and how they are turned, R_WL
  // m, the root of the summed squared distances to the goals or their boxes; turns count by
  // kTurnLength
  double distance = 0.0;

  [[nodiscard]] bool reached(double tolerance = kReachTolerance) const {
    return distance <= tolerance;
  }
};

// Searches the posture that brings the effectors nearest to their paths' ends, by damped
// Gauss-Newton steps of weighted IK with the planted feet as exact constraints, from several
// postures. Joint limits hold where the problem holds them (the paper's IK does not look at them).
// It stops early at a goal that is met; of postures whose distances differ by less than 5 mm, none
// meeting the goal, it takes the one nearest to the start posture's own descent. Heels that may
// lift do so where flat feet do not bring the effectors to their goals. Deterministic.
[[nodiscard]] ClosestReach closest_reach(const ReachProblem& problem,
                                         const ReachabilitySettings& settings = {});

// The problem with goals on the lines from where the effectors start to its own, of which the
// nearest posture, `reach`, has a limb in the rest of the body, deeper than flesh yields, than at
// the start and than kDetourDepth: as far along, by tenths, as that limb is clear. The same problem
// where the posture is clear, or none is.
[[nodiscard]] ReachProblem clear_goals(const ReachProblem& problem, const ClosestReach& reach);

}  // namespace shigusa
