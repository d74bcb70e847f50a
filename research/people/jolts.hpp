// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shigusa::bench {

// How many generated motions jolt, where and by which joint.
[[nodiscard]] std::string jolts_section();

}  // namespace shigusa::bench
