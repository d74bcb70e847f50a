// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/landmarks.hpp>
#include <shigusa/message.hpp>
#include <string>

namespace shigusa {

// Why a figure with the limbs that were found is no person, with what was measured; empty where it
// may be one. Children, dwarfs, figures with big heads, the arms of giants and robots may be: only
// limbs of lengths that no figure has tell, and the stance on four legs. Of the landmarks limbs
// alone count, in any unit and posture.
[[nodiscard]] Message unlike_a_person(const Landmarks& figure);

}  // namespace shigusa
