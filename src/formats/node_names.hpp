// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace shigusa {

// Longest name; longer ones are cut. A number that is added fits within BVH's limit.
inline constexpr std::size_t kNodeNameBytes = 240;

// Generator of unique joint names.
class NodeNames {
 public:
  // The name made valid for files: UTF-8 without control characters, braces and surrounding blanks,
  // "joint" if empty, and with "_2", "_3", … if it is taken.
  [[nodiscard]] std::string take(std::string_view name);

 private:
  std::map<std::string, int> taken_;  // and the number that the name was last given with
};

}  // namespace shigusa
