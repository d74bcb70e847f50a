// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "data_rows.hpp"

namespace shigusa {

// "a person squats, turns left and reaches down in front with the right hand, holding 5 kg": a
// motion in words, by its goals, its end and its loads.
[[nodiscard]] std::string caption_of(const DataMotion& motion);

// The words of such a sentence as HumanML3D has them, "a/DET person/NOUN squat/VERB": nouns and
// verbs in their plain form, no numbers.
[[nodiscard]] std::string tokens_of(const std::string& caption);

}  // namespace shigusa
