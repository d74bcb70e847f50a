// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "folder.hpp"

namespace shigusa {

// Whether a name is one that a Staging has.
[[nodiscard]] bool is_staging_name(std::string_view name);

// Removes what killed programs left in a folder, of what Staging makes there.
void remove_leftovers(const Descriptor& folder);

// A new folder within another one, in which files are made whole before they take their names. It
// has a name of its own each time, ".shigusa-5e0c….tmp", and is locked while it lives: one that
// nobody holds is a killed program's. Goes with what is left in it.
//
// Functions give 0, or the system's reason (errno).
class Staging {
 public:
  Staging() = default;
  Staging(Staging&&) noexcept = default;
  Staging& operator=(Staging&&) = delete;
  ~Staging();

  // Opens the folder that it is to be in.
  [[nodiscard]] int open(const std::filesystem::path& path);

  // Removes what killed programs left in the folder, and makes this one.
  [[nodiscard]] int make();

  // The folder that it is in.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const Descriptor& folder() const { return folder_; }

  // A new file, for writing and reading; none, with errno, where it fails. Somebody else may write
  // it by its path meanwhile.
  [[nodiscard]] Descriptor create(const std::string& name);
  [[nodiscard]] std::filesystem::path path_of(const std::string& name) const;

  // A new file. `durable`: it is on the disk, and not on its way there, when this returns.
  [[nodiscard]] int add(const std::string& name, std::string_view bytes, bool durable);

  // Gives a file of it its name in the folder, in the place of any file or link that has it, whose
  // permissions it takes over.
  [[nodiscard]] int move_out(const std::string& name, const std::string& to);

 private:
  [[nodiscard]] int make_locked(const std::string& name);

  std::filesystem::path path_;
  Descriptor folder_;
  Descriptor self_;  // none before it is made
  std::string name_;
  std::vector<std::string> files_;  // in it
};

}  // namespace shigusa
