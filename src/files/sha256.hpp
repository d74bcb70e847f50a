// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "descriptor.hpp"

namespace shigusa {

// The SHA-256 of bytes (FIPS 180-4), as 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view bytes);

// SHA-256 of the rest of a file; empty on failure, with errno.
[[nodiscard]] std::string sha256_of(const Descriptor& file);

}  // namespace shigusa
