// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <shigusa/error.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shigusa::npy {

// NumPy arrays (.npy, version 1.0): a header, then numbers in row-major order, little-endian. The
// shape of a single number is empty.
using Shape = std::vector<std::size_t>;

[[nodiscard]] std::string floats(const std::vector<float>& values, const Shape& shape);
[[nodiscard]] std::string doubles(const std::vector<double>& values, const Shape& shape);
[[nodiscard]] std::string integers(const std::vector<std::int32_t>& values, const Shape& shape);
// Array of texts from UTF-8.
[[nodiscard]] std::string texts(const std::vector<std::string>& values);
[[nodiscard]] std::string text(std::string_view value);

// Named arrays as one archive (.npz), as numpy.savez writes it: uncompressed and without times, so
// that the bytes depend on the arrays alone.
using Arrays = std::vector<std::pair<std::string, std::string>>;
[[nodiscard]] Result<std::string> archive(const Arrays& arrays);

}  // namespace shigusa::npy
