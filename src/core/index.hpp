// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shigusa {

// A non-negative int as an index into an array. Always inlined: files compiled for a SIMD set must
// not emit it for others.
[[nodiscard, gnu::always_inline]] constexpr std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace shigusa
