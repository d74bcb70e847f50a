// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <list>
#include <mutex>
#include <shigusa/character.hpp>
#include <string>
#include <utility>

namespace shigusa {

// Cache of a data set's characters. A file is measured once per drawn build, and the most recent
// ones are kept, as many tasks share few. Thread-safe.
class Cast {
 public:
  // Characters' files are relative to `folder`.
  explicit Cast(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // The measured character.
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
