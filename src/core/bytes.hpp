// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace shigusa {

// Appends an integer as bytes, little-endian on any machine.

template <std::unsigned_integral T>
void append_bytes(std::string& to, T x) {
  for (std::size_t k = 0; k < sizeof x; ++k) to += static_cast<char>((x >> (8 * k)) & 0xFF);
}

// The little-endian integer at a position of the bytes, which must contain it.
template <std::unsigned_integral T>
[[nodiscard]] T integer_at(std::string_view bytes, std::size_t at) {
  T x = 0;
  for (std::size_t k = sizeof x; k-- > 0;) {
    x = static_cast<T>(std::uint64_t{x} << 8 | static_cast<unsigned char>(bytes[at + k]));
  }
  return x;
}

}  // namespace shigusa
