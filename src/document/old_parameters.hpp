// SPDX-License-Identifier: MIT
#pragma once

#include "formats/json_text.hpp"

namespace shigusa {

// Converts a candidate's values from the format of older results, with the objects "weights",
// "contractions", "posture", "arms", "supports" and "rest", to today's. Members of neither format
// are kept; their reader reports them.
[[nodiscard]] Json from_old_parameters(const Json& parameters);

}  // namespace shigusa
