// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shigusa {

// The place in an array that a number of the interface names. Must not be negative.
[[nodiscard]] constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace shigusa
