// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/action.hpp>
#include <shigusa/body.hpp>
#include <span>
#include <string>
#include <vector>

#include "work/moment.hpp"

namespace shigusa {

// Widest thing (m) that one hand takes, and heaviest (kg): an open hand spans some 0.1 m.
inline constexpr double kOneHandWidth = 0.1;
inline constexpr double kOneHandMass = 3.0;
// Heaviest thing (kg) that one hand takes by its handle, chosen.
inline constexpr double kHandleMass = 15.0;

// Distance (m) of a palm's capsule from what it holds, and depth to which that gives way to the
// forearm: a wrist is flatter than its capsule, by some 14 mm.
inline constexpr double kTouch = 0.006;

// Ways to take a thing: of each the goals of the hands. The best one is first.
using Holds = std::vector<std::vector<Goal>>;

// Ways to take a thing from a moment: by two hands from its sides with the palms facing each other,
// by one hand around the bar of its handle, from the side with the thumb up, or from above. Ways
// through an obstacle are left out. `hands`: names of effectors that take it; empty: by its size
// and mass, two or the nearer one. `higher`: height (m) by which it will be put higher.
[[nodiscard]] Holds holds_of(const BodyModel& body, const Kinematics<double>& placed,
                             const Thing& thing, const Transformd& pose,
                             std::span<const std::string> hands,
                             std::span<const Obstacle> obstacles, double higher = 0.0);

// Whether a thing is for two hands: wider than one spans, or heavier than one likes; with a handle
// only a heavy one.
[[nodiscard]] bool takes_two(const Thing& thing);

// Name of a hand of the body, "right_hand"; empty if it has none on that side.
[[nodiscard]] std::string hand_name(const BodyModel& body, Side side);

}  // namespace shigusa
