// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace shigusa {

// The path of a text in UTF-8. A path made of a std::string is right of POSIX only: of Windows it
// would take each byte for a character.
[[nodiscard]] std::filesystem::path to_path(std::string_view text);

}  // namespace shigusa
