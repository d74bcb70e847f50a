// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "descriptor.hpp"

namespace shigusa {

// Opens a folder. On failure the descriptor is empty and errno is set.
[[nodiscard]] Descriptor open_folder(const std::filesystem::path& path);

// Opens a file or folder within for reading, without following links or waiting.
[[nodiscard]] Descriptor open_entry(const Descriptor& folder, const std::string& name);

// Names in a folder except "." and ".."; empty if it cannot be read.
[[nodiscard]] std::vector<std::string> names_in(const Descriptor& folder);

// Type of an open file, and of a name in a folder, where a link is a symlink; not_found if unknown.
[[nodiscard]] std::filesystem::file_type type_of(const Descriptor& entry);
[[nodiscard]] std::filesystem::file_type type_in(const Descriptor& folder, const std::string& name);

// The following functions return 0 or errno.

// Whether the user may write to a file.
[[nodiscard]] int check_writable(const Descriptor& folder, const std::string& name);
// Removes a file or link.
int remove_in(const Descriptor& folder, const std::string& name);
// Flushes a file's bytes, or a folder's names, to the disk; some file systems do not support it.
[[nodiscard]] int settle(const Descriptor& entry);

// Locks a file or folder until it is closed, exclusively or shared; false if another program's lock
// prevents it. File systems without locks are used unlocked.
enum class LockKind { alone, shared };
[[nodiscard]] bool try_lock(const Descriptor& entry, LockKind kind);

}  // namespace shigusa
