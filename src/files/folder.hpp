// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "descriptor.hpp"

namespace shigusa {

// A folder, for what follows. Where it fails the descriptor is none, and errno tells why.
[[nodiscard]] Descriptor open_folder(const std::filesystem::path& path);

// A file or folder within, for reading: no link is followed, and nothing is waited for.
[[nodiscard]] Descriptor open_entry(const Descriptor& folder, const std::string& name);

// The names in a folder, but for "." and ".."; none where it cannot be read.
[[nodiscard]] std::vector<std::string> names_in(const Descriptor& folder);

// The type of what is open, and of what has a name in a folder, where a link is a symlink. Where it
// cannot be told it is not_found.
[[nodiscard]] std::filesystem::file_type type_of(const Descriptor& entry);
[[nodiscard]] std::filesystem::file_type type_in(const Descriptor& folder, const std::string& name);

// These give 0, or the system's reason (errno).

// Whether the user may write to a file.
[[nodiscard]] int check_writable(const Descriptor& folder, const std::string& name);
// Removes a file or link.
int remove_in(const Descriptor& folder, const std::string& name);
// Sees to it that the bytes of a file, or the names in a folder, are on the disk; some file systems
// cannot tell.
[[nodiscard]] int settle(const Descriptor& entry);

// Locks a file or folder until it is closed, for this program or for all that share it; false where
// another program keeps it from that. A file system without locks goes without.
enum class LockKind { alone, shared };
[[nodiscard]] bool try_lock(const Descriptor& entry, LockKind kind);

}  // namespace shigusa
