// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <shigusa/error.hpp>
#include <string>
#include <string_view>

namespace shigusa {

/// Reads the bytes of a file, unchanged. A file larger than `max_bytes` (or an endless device) is
/// refused before more memory is allocated, and so is a named pipe, which might never answer; the
/// program's own streams (/dev/stdin) are read. Errors have the path as their place and the
/// system's reason: ErrorCode::not_found for a missing file, else ErrorCode::io.
[[nodiscard]] Result<std::string> read_text_file(const std::filesystem::path& path,
                                                 std::size_t max_bytes);

/// Writes `bytes` to `path`, atomically: they go to a new file beside it, which then takes the
/// name, so that a failure, such as a full disk, leaves the old file intact and no other file;
/// remains of a killed program are removed. A symbolic link keeps pointing to its file, and an
/// existing file keeps its permissions. Creates no folders. Devices and the program's own streams
/// are written directly; a named pipe is refused.
[[nodiscard]] Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace shigusa
