// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace shigusa {

// The path of a text in UTF-8. A path made of a std::string is right of POSIX only: of Windows it
// would take each byte for a character.
[[nodiscard]] std::filesystem::path to_path(std::string_view text);

// Absolute path in an environment variable; empty for none and for a relative one, as the XDG Base
// Directory Specification asks.
[[nodiscard]] std::optional<std::filesystem::path> path_in_environment(const char* variable);

#ifdef _WIN32
// Text of Windows in UTF-8; what is no UTF-16 becomes replacement characters.
[[nodiscard]] std::string to_utf8(std::wstring_view text);
#endif

}  // namespace shigusa
