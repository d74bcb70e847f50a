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

// Locks a folder until it is closed, alone to write results to it and shared to read them, so that
// programs take turns; other programs are not kept out. Waits for others, for so long at most. A
// file system without locks goes without: what a result says of its files then tells a mixture.
[[nodiscard]] Result<void> lock_folder(
    const Descriptor& folder, LockKind kind, const std::filesystem::path& path,
    std::chrono::milliseconds longest = std::chrono::seconds(10));

// Writes a result into a folder so that it is whole or absent, whatever ends the program and
// however many write at once:
//
//   write all files beside, into a Staging, and see to it that they are on the disk;
//   lock the folder; refuse what stands in the place of a file and is none;
//   remove the old summary; give the files their names; remove those of an older result;
//   give the summary its name.
//
// Until the lock is held an older result stays as it is, a full disk leaves it so, and a summary
// never stands beside files that it does not describe. Files that are no result's stay.
class ResultFolder {
 public:
  // Opens the folder, which must be there.
  [[nodiscard]] Result<void> open(const std::filesystem::path& folder);

  // Adds a file; its SHA-256.
  [[nodiscard]] Result<std::string> add(const std::string& name, std::string_view bytes);

  // Puts all that was added, and this summary, in the place of what result is there. Files of
  // candidates (is_result_file) that were not added are removed.
  [[nodiscard]] Result<void> publish(std::string_view summary);

 private:
  [[nodiscard]] Result<void> check_place(const std::string& name) const;
  [[nodiscard]] Result<void> swap();
  [[nodiscard]] Result<void> settle_names() const;
  void remove_older() const;

  Staging staging_;
  std::vector<std::string> files_;
};

// Fails where one of these files is in the folder and is not the one that is described. One that
// is not there is no failure.
[[nodiscard]] Result<void> check_described(const std::filesystem::path& path,
                                           const Descriptor& folder, const CandidateFiles& files);

}  // namespace shigusa
