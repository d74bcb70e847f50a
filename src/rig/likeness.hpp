// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/human.hpp>
#include <string>

namespace shigusa {

// Of a limb's two segments the longer over the shorter one; people have 1.3 at most.
inline constexpr double kMostUnevenSegments = 5.0;

// Why a figure with the limbs that were found is no person, with what was measured; empty where it
// may be one. Children, dwarfs, figures with big heads, the arms of giants and robots may be: only
// limbs of lengths that no figure has tell, and the stance on four legs. Of the landmarks limbs
// alone count, in any unit and posture.
[[nodiscard]] Message unlike_a_person(const Landmarks& figure);

// Whether the trunk lies level over four limbs that reach down alike; of an animal that is, or a
// person who touches the floor.
[[nodiscard]] bool stands_on_four(const Landmarks& figure);

}  // namespace shigusa
