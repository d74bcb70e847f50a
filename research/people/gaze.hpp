// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shigusa::bench {

// How many motions of one hand end with the eyes on the goal.
[[nodiscard]] std::string gaze_section();

}  // namespace shigusa::bench
