// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <shigusa/error.hpp>
#include <string>
#include <string_view>

namespace shigusa {

/// The bytes of a file, unchanged. At most `max_bytes`: a larger file (or an endless device) is
/// refused before more memory than that is taken. So is a named pipe, which may never answer; the
/// program's own streams (/dev/stdin) are read. Errors carry the path as their place and the
/// system's reason: a missing file is ErrorCode::not_found, anything else ErrorCode::io.
[[nodiscard]] Result<std::string> read_text_file(const std::filesystem::path& path,
                                                 std::size_t max_bytes);

/// Makes `path` hold exactly `bytes`. They go to a new file beside it, which then takes the name: a
/// failure, a full disk among them, leaves the old file whole and nothing beside it, and what a
/// killed program left beside it is removed. A symbolic link keeps pointing to its file, and an old
/// file keeps its permissions. Creates no folders. Devices and the program's own streams are
/// written to directly; a named pipe is refused.
[[nodiscard]] Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace shigusa
