// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/human.hpp>

namespace shigusa {

// How a person carries themselves in one posture, by joints and soles alone. The person may face
// any way and be at any height.

// Centre of mass (m) of a person of average build.
[[nodiscard]] Vec3d centre_of_mass(const Landmarks& person, double stature);

// Whether a person holds both arms straight and alike out to the sides, 30° to 125° from hanging,
// or ahead, 60° to 125°, on straight legs: a T, an A or a robot's zero, in which people are
// modelled and recordings begin.
[[nodiscard]] bool spreads_arms(const Landmarks& person);

// Whether a person stands as one who has not begun to move: upright on both feet, knees no more
// than a little bent, left and right alike. A person who leaps or is ready to fight does not.
[[nodiscard]] bool stands_at_rest(const Landmarks& person, double stature);

// Whether a person stands on both feet: both soles level and at one height, legs, trunk and centre
// of mass over them. Arms do as they like. Somebody who walks stands so for moments.
[[nodiscard]] bool stands_on_both_feet(const Landmarks& person, double stature);

// The height (m, over the lower sole) of the seat below a person who sits on one: thighs rather
// level, trunk rather upright, and the centre of mass beside the feet. Nothing below others.
[[nodiscard]] std::optional<double> seat_below(const Landmarks& person, double stature);

// Whether a person lies or crawls: head, trunk and legs close to one level.
[[nodiscard]] bool lies(const Landmarks& person, double stature);

}  // namespace shigusa
