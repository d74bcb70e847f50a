// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shigusa::bench {

// Statistics of jolts in generated motions: frequency, time and joint.
[[nodiscard]] std::string jolts_section();

}  // namespace shigusa::bench
