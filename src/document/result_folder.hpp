// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "files/staging.hpp"

namespace shigusa {

// Locks a folder until it is closed, exclusively to write results and shared to read them. The lock
// is advisory: programs that do not take it are not kept out. Waits for other holders for at most
// `longest`. File systems without locks are used unlocked, where a result may then describe a
// mixture of files.
[[nodiscard]] Result<void> lock_folder(
    const Descriptor& folder, LockKind kind, const std::filesystem::path& path,
    std::chrono::milliseconds longest = std::chrono::seconds(10));

// Writes a result into a folder so that it is whole or absent, wherever the program ends and
// however many processes write at once:
//
//   write all files into a Staging beside it and flush them to the disk;
//   lock the folder; refuse non-files that stand in the place of a file;
//   remove the old summary; rename the files to their names; remove those of an older result;
//   rename the summary to its name.
//
// An older result is untouched until the lock is held, also if the disk is full, and a summary
// never stands beside files that it does not describe. Files that belong to no result are kept.
class ResultFolder {
 public:
  // Opens an existing folder.
  [[nodiscard]] Result<void> open(const std::filesystem::path& folder);

  // Adds a file; returns its SHA-256.
  [[nodiscard]] Result<std::string> add(const std::string& name, std::string_view bytes);

  // Replaces the folder's result by the added files and this summary. Files of candidates
  // (is_result_file) that were not added are removed.
  [[nodiscard]] Result<void> publish(std::string_view summary);

 private:
  [[nodiscard]] Result<void> check_place(const std::string& name) const;
  [[nodiscard]] Result<void> swap();
  [[nodiscard]] Result<void> settle_names() const;
  void remove_older() const;

  Staging staging_;
  std::vector<std::string> files_;
};

// Fails if one of these files is in the folder with other contents than described. Absent files are
// no failure.
[[nodiscard]] Result<void> check_described(const std::filesystem::path& path,
                                           const Descriptor& folder, const CandidateFiles& files);

}  // namespace shigusa
