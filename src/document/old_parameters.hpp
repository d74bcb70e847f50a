// SPDX-License-Identifier: MIT
#pragma once

#include "formats/json_text.hpp"

namespace shigusa {

// The values of a candidate as results hold them, of those as older results have them:
// "weights", "contractions", "posture", "arms", "supports" and "rest", each by the names in it.
// Members of neither form stay as they are, and are told where they are read.
[[nodiscard]] Json from_old_parameters(const Json& parameters);

}  // namespace shigusa
