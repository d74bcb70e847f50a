// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>

namespace shigusa {

// Distance (rad) up to which two motions are one candidate for the presets paper and layers: root
// mean square over the dofs, the largest over the frames.
inline constexpr double kDistinctPosture = radians(5.0);
// Distance of final postures (rad, root mean square) up to which two motions of a Pareto front are
// one candidate.
inline constexpr double kDistinctEnd = radians(10.0);
// Largest score difference of a candidate from the best one; see also kShownLeast.
inline constexpr double kCandidateSpread = 0.6;
// Number of feasible candidates that are delivered whatever their score.
inline constexpr int kShownLeast = 3;
// Largest score difference of the best candidate of another style, if the best one bends down:
// people squat although it costs more, and some stoop.
inline constexpr double kStyleSpread = 1.5;
// Largest swivel of the elbow of people who squat, whose arms are between their knees, and the
// score by which such a squat may be worse than another one.
inline constexpr double kElbowBetween = radians(30.0);
inline constexpr double kElbowSpread = 0.3;
// Score difference between search and replay that is not counted in SearchLog. Searches score in
// single precision, replays in double; feasibility and jolts depend on peak accelerations, which
// single precision changes by some 2e-3 rad/s².
inline constexpr double kReplayTolerance = 0.05;
// Distance (m) from the closest reachable point within which a candidate must end if its goal is
// out of reach.
inline constexpr double kEdgeTolerance = 5e-3;

}  // namespace shigusa
