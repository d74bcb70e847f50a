// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace shigusa {

// Fowler, Noll and Vo's hash (FNV-1a, 64 bits), the same on any machine.
class Fnv1a {
 public:
  // Mixes in one number in one step, usually a byte.
  void mix(std::uint64_t x) { value_ = (value_ ^ x) * 0x100000001B3ULL; }
  void add(std::string_view bytes) {
    for (const char c : bytes) mix(static_cast<unsigned char>(c));
  }
  // Mixes in a number's bytes, little-endian.
  void add(std::uint64_t x) {
    for (int k = 0; k < 8; ++k) mix((x >> (8 * k)) & 0xFF);
  }
  void add(double x) { add(__builtin_bit_cast(std::uint64_t, x)); }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

}  // namespace shigusa
