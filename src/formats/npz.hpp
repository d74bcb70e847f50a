// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace shigusa {

// Values of an array of type <f8, <f4, <i4, |b1 (0 or 1) or text (from UTF-8).
using NpzValues = std::variant<std::vector<double>, std::vector<float>, std::vector<std::int32_t>,
                               std::vector<std::uint8_t>, std::vector<std::string>>;

// An array of NumPy in row-major order; the shape of a single value is empty.
struct NpzArray {
  std::string name;
  std::vector<std::size_t> shape;
  NpzValues values;
};

// Arrays as one archive, as numpy.savez writes it: stored, not packed, and without times, so that
// the bytes depend on the arrays alone. Preconditions: as many values as the shape has, and less
// than 4 GiB.
[[nodiscard]] std::string format_npz(std::span<const NpzArray> arrays);

}  // namespace shigusa
