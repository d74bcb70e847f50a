// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace shigusa {

// Base64 of bytes, with padding (RFC 4648, section 4).
[[nodiscard]] std::string to_base64(std::string_view bytes);
// The bytes of a base64 text, up to its padding; nothing for a character of another alphabet.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace shigusa
