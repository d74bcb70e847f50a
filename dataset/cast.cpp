// SPDX-License-Identifier: MIT
#include "cast.hpp"

#include <algorithm>
#include <shigusa/files.hpp>

namespace shigusa {

Result<CharacterSpec> Cast::measured(const CharacterSpec& asked) {
  if (is_complete(asked)) return asked;
  TaskFile file;
  file.character = asked;
  const std::string key = format_task(file);
  {
    const std::lock_guard lock(mutex_);
    const auto known = std::find_if(kept_.begin(), kept_.end(),
                                    [&key](const auto& kept) { return kept.first == key; });
    if (known != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, known);
      return known->second;
    }
  }
  CharacterSpec spec = asked;
  SHG_TRY(measure_character(spec, folder_));
  const std::lock_guard lock(mutex_);
  kept_.emplace_front(key, spec);
  if (kept_.size() > kKept) kept_.pop_back();
  return spec;
}

}  // namespace shigusa
