// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace shigusa {

// The longest name; longer ones are cut. A number that is added fits in what BVH allows.
inline constexpr std::size_t kNodeNameBytes = 240;

// Gives out joint names, each once.
class NodeNames {
 public:
  // The name as it may stand in a file: valid UTF-8 without control characters, braces and blanks
  // around it, "joint" if empty, and with "_2", "_3", … where it was taken before.
  [[nodiscard]] std::string take(std::string_view name);

 private:
  std::map<std::string, int> taken_;  // and the number that the name was last given with
};

}  // namespace shigusa
