// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/human.hpp>

namespace shigusa {

// Measures and classification of one posture, by joints and soles alone. The person may face any
// way and be at any height.

// Centre of mass (m) of a person of average build.
[[nodiscard]] Vec3d centre_of_mass(const Landmarks& person, double stature);

// Whether the arms are straight and symmetric, 30° to 125° from hanging to the sides or 60° to 125°
// ahead, on straight legs: a T, an A or a robot's zero posture, as used for modelling and
// calibration.
[[nodiscard]] bool spreads_arms(const Landmarks& person);

// Whether a person stands as before a motion: upright on both feet, knees at most slightly bent,
// left and right alike. A leap or a fighting stance does not count.
[[nodiscard]] bool stands_at_rest(const Landmarks& person, double stature);

// Whether a person stands on both feet: soles level and at one height, with legs, trunk and centre
// of mass over them. Arms are ignored. A walking person stands so for moments.
[[nodiscard]] bool stands_on_both_feet(const Landmarks& person, double stature);

// Height (m, over the lower sole) of the seat under a sitting person: thighs fairly level, trunk
// fairly upright, and centre of mass beside the feet. Empty for other postures.
[[nodiscard]] std::optional<double> seat_below(const Landmarks& person, double stature);

// Whether a person lies or crawls: head, trunk and legs at nearly one height.
[[nodiscard]] bool lies(const Landmarks& person, double stature);

}  // namespace shigusa
