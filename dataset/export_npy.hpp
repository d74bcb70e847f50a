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

// Arrays as NumPy keeps them in files (.npy, version 1.0): a header, then numbers in rows, the
// lowest byte first. Shapes: none of a single number.
using Shape = std::vector<std::size_t>;

[[nodiscard]] std::string floats(const std::vector<float>& values, const Shape& shape);
[[nodiscard]] std::string doubles(const std::vector<double>& values, const Shape& shape);
[[nodiscard]] std::string integers(const std::vector<std::int32_t>& values, const Shape& shape);
[[nodiscard]] std::string number(double value);
[[nodiscard]] std::string whole(std::uint64_t value);
// Texts from UTF-8.
[[nodiscard]] std::string texts(const std::vector<std::string>& values);
[[nodiscard]] std::string text(std::string_view value);

// Arrays by their names as one archive (.npz), as numpy.savez makes it: nothing is packed, and no
// time is in it, so that the bytes are those of the arrays alone.
using Arrays = std::vector<std::pair<std::string, std::string>>;
[[nodiscard]] Result<std::string> archive(const Arrays& arrays);

}  // namespace shigusa::npy
