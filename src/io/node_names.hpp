// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace shigusa {

// Gives out joint names, each once.
class NodeNames {
 public:
  // `spaces`: whether names keep their blanks; otherwise these become '_' too.
  explicit NodeNames(bool spaces) : spaces_(spaces) {}

  // The name as it may stand in a file: valid UTF-8 without control characters and braces, "joint"
  // if empty, and with "_2", "_3", … where it was taken before.
  [[nodiscard]] std::string take(std::string_view name);

 private:
  bool spaces_;
  std::map<std::string, int> taken_;  // and the number that the name was last given with
};

}  // namespace shigusa
