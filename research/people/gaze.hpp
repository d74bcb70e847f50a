// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shigusa::bench {

// Counts of one-handed motions that end with the eyes on the goal.
[[nodiscard]] std::string gaze_section();

}  // namespace shigusa::bench
