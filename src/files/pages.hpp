// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shigusa {

// Memory from the operating system, for when the C library has none; null if there is none either.
[[nodiscard]] void* take_pages(std::size_t bytes);
void give_pages(void* pages, std::size_t bytes) noexcept;

}  // namespace shigusa
