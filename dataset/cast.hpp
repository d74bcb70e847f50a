// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <list>
#include <mutex>
#include <shigusa/character.hpp>
#include <string>
#include <utility>

namespace shigusa {

// Those who move in a data set. A file is measured once for each build that is drawn of it, and the
// last few of these are kept: many tasks are of the same few. May be asked by several threads.
class Cast {
 public:
  // Characters' files are looked for in `folder`.
  explicit Cast(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // The character as measured.
  [[nodiscard]] Result<CharacterSpec> measured(const CharacterSpec& asked);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  static constexpr std::size_t kKept = 64;

  std::filesystem::path folder_;
  std::mutex mutex_;
  std::list<std::pair<std::string, CharacterSpec>>
      kept_;  // by their JSON text, the last used first
};

}  // namespace shigusa
