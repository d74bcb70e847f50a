// SPDX-License-Identifier: MIT
#pragma once

#include "rollout/reach_problem.hpp"

namespace shigusa {

// Haste of a hand's path (EffectorPath::haste), fitted to recorded people: the more it rises, the
// faster its first half.
[[nodiscard]] double natural_haste(const EffectorPath& path);

// Share of the duration before a hand leaves for its goal (EffectorPath::begin), fitted to recorded
// people.
[[nodiscard]] double natural_begin(const EffectorPath& path);

// Time of the hips, with the trunk, in a rise from a bent start: after the knees.
inline constexpr TimeWindow kHipsRise{0.2, 1.0};

// Timing of the body parts' change of posture in motions along these paths, fitted to recorded
// people.
[[nodiscard]] PartWindows natural_windows(std::span<const ReachGoal> goals);

// Duration (s) of a reach with a load (kg) in the hands: rule R9's, but for near goals that of
// MTM-1 (R-B and M-B, .16 s + 1.0 s/m, times kPace); without the jump where the trunk begins to
// help; with the weight's factor and constant of MTM-1, and less for goals of which a whole box
// will do (P. Fitts, J. Experimental Psychology 47 (1954) 381).
[[nodiscard]] double natural_duration(const BodyModel& body, const Kinematics<double>& start,
                                      const ReachGoal& goal, double load);

}  // namespace shigusa
