// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shigusa::bench {

// How often goals beside one another are reached in different styles.
[[nodiscard]] std::string evenness_section();

}  // namespace shigusa::bench
