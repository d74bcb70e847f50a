// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shigusa::bench {

// Whether candidates are styles that people use for their goals, with tables.
[[nodiscard]] std::string candidates_section();

}  // namespace shigusa::bench
