// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "data_rows.hpp"

namespace shigusa {

// Caption of a motion from its goals, its end and its loads, such as "a person squats, turns left
// and reaches down in front with the right hand, holding 5 kg".
[[nodiscard]] std::string caption_of(const DataMotion& motion);

// Tokens of such a sentence in the format of HumanML3D, "a/DET person/NOUN squat/VERB": nouns and
// verbs as lemmas, without numbers.
[[nodiscard]] std::string tokens_of(const std::string& caption);

}  // namespace shigusa
