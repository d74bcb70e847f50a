// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/human.hpp>
#include <string>

namespace shigusa {

// Largest ratio of a limb's two segments; people have 1.3 at most.
inline constexpr double kMostUnevenSegments = 5.0;

// Reason why a figure with the limbs found is no person, with the measured values; empty if it may
// be one. Children, dwarfs, big heads, giants' arms and robots are accepted: the criteria are limb
// lengths beyond those of any figure, and a stance on four legs. Only the limb landmarks are used,
// in any unit and posture.
[[nodiscard]] Message unlike_a_person(const Landmarks& figure);

// Whether the trunk is level over four limbs that reach down equally, as of an animal or of a
// person touching the floor.
[[nodiscard]] bool stands_on_four(const Landmarks& figure);

}  // namespace shigusa
