// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "descriptor.hpp"

namespace shigusa {

// The functions that open return an empty descriptor on failure, and set errno.

// Opens a folder.
[[nodiscard]] Descriptor open_folder(const std::filesystem::path& path);

// Opens a file or folder within for reading, without following links or waiting.
[[nodiscard]] Descriptor open_entry(const Descriptor& folder, const std::string& name);

// Creates a file within for reading and writing.
[[nodiscard]] Descriptor create_in(const Descriptor& folder, const std::string& name);

// Names in a folder except "." and ".."; empty if it cannot be read.
[[nodiscard]] std::vector<std::string> names_in(const Descriptor& folder);

// Type of an open file, and of a name in a folder, where a link is a symlink; not_found if unknown.
[[nodiscard]] std::filesystem::file_type type_of(const Descriptor& entry);
[[nodiscard]] std::filesystem::file_type type_in(const Descriptor& folder, const std::string& name);

// Whether a name in a folder is that of an open file or folder.
[[nodiscard]] bool is_named(const Descriptor& entry, const Descriptor& folder,
                            const std::string& name);

// Whether a file or folder was last changed so long ago.
[[nodiscard]] bool older_than(const Descriptor& entry, std::chrono::seconds age);

// The following functions return 0 or errno.

// Whether the user may write to a file.
[[nodiscard]] int check_writable(const Descriptor& folder, const std::string& name);
// Makes a folder for this user alone.
[[nodiscard]] int make_folder_in(const Descriptor& folder, const std::string& name);
// Removes a file or link.
int remove_in(const Descriptor& folder, const std::string& name);
// Removes an empty folder.
int remove_folder_in(const Descriptor& folder, const std::string& name);
// Moves a file to a name in another folder, replacing a file or link of that name and taking over
// a file's permissions.
[[nodiscard]] int move_in(const Descriptor& from, const std::string& name, const Descriptor& folder,
                          const std::string& to);
// Flushes a file's bytes, or a folder's names, to the disk; some file systems do not support it.
[[nodiscard]] int settle(const Descriptor& entry);

// Locks a file or folder until it is closed, exclusively or shared; EWOULDBLOCK if another
// program's lock prevents it, another number if the file system has no locks.
enum class LockKind { alone, shared };
[[nodiscard]] int lock_now(const Descriptor& entry, LockKind kind);

// As lock_now; false if another program's lock prevents it. File systems without locks are used
// unlocked.
[[nodiscard]] inline bool try_lock(const Descriptor& entry, LockKind kind) {
  const int reason = lock_now(entry, kind);
  return reason != EWOULDBLOCK && reason != EINTR;
}

}  // namespace shigusa
