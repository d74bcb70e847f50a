// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace shigusa {

// The number that the whole text writes, "-0.5", "+1e3", ".5" or "inf", nearest double. It has a
// point in every locale that the program may have chosen. A number too large for a double becomes
// infinite, what is too small 0. None for anything else: blanks around it, "1,5", "0x10".
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

}  // namespace shigusa
