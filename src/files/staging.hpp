// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "folder.hpp"

namespace shigusa {

// Whether a name is one of a Staging's.
[[nodiscard]] bool is_staging_name(std::string_view name);

// Removes staging folders that killed programs left in a folder.
void remove_leftovers(const Descriptor& folder);

// A temporary folder within another one, in which files are completed before they are renamed. It
// has a unique name, ".shigusa-5e0c….tmp", and is locked while it lives: an unlocked one is left
// from a killed program. It is removed with its remaining files.
//
// Functions return 0 or errno.
class Staging {
 public:
  Staging() = default;
  Staging(Staging&&) noexcept = default;
  Staging& operator=(Staging&&) = delete;
  ~Staging();

  // Opens the parent folder.
  [[nodiscard]] int open(const std::filesystem::path& path);

  // Removes leftovers of killed programs from the parent, and creates this folder.
  [[nodiscard]] int make();

  // The parent folder.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const Descriptor& folder() const { return folder_; }

  // Creates a file for reading and writing; empty on failure, with errno. Other programs could
  // write to it by its path.
  [[nodiscard]] Descriptor create(const std::string& name);
  [[nodiscard]] std::filesystem::path path_of(const std::string& name) const;

  // Creates a file with contents. `durable`: it is flushed to the disk.
  [[nodiscard]] int add(const std::string& name, std::string_view bytes, bool durable);

  // Moves a file to its name in the parent, replacing a file or link of that name and taking over
  // its permissions.
  [[nodiscard]] int move_out(const std::string& name, const std::string& to);

 private:
  [[nodiscard]] int make_locked(const std::string& name);

  std::filesystem::path path_;
  Descriptor folder_;
  Descriptor self_;  // empty before it is created
  std::string name_;
  std::vector<std::string> files_;  // files within
};

}  // namespace shigusa
