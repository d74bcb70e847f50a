// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

namespace shigusa::bench {

// The parts of a text between each `at`; one at least.
inline std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace shigusa::bench
