// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace shigusa {

// Gives out joint names, each once.
class BvhNames {
 public:
  // `spaces`: whether names keep their blanks; otherwise these become '_' too.
  explicit BvhNames(bool spaces) : spaces_(spaces) {}

  // The name as it may stand in a file: valid UTF-8 without control characters and braces, "joint"
  // if empty, and with "_2", "_3", … where it was taken before.
  [[nodiscard]] std::string take(std::string_view name);

 private:
  bool spaces_;
  std::set<std::string, std::less<>> taken_;
};

}  // namespace shigusa
