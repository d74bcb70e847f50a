// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdio>
#include <string_view>

#include "commands.hpp"

namespace shigusa::app {

// A line that tells how far work has come, on stderr: drawn anew on a terminal, and a line a minute
// elsewhere, as in a job's log.
class PacedLine {
 public:
  // Whether it is time for the line, whose text may take some making.
  [[nodiscard]] bool is_due() {
    if (Clock::now() - last_ < pause_) return false;
    last_ = Clock::now();
    return true;
  }
  void show(std::string_view text) const {
    print_err("{}{}{}", terminal_ ? "\r\x1b[K" : "shigusa: ", text, terminal_ ? "" : "\n");
    std::fflush(stderr);
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool terminal_ = is_terminal();
  Clock::duration pause_ = terminal_ ? std::chrono::milliseconds(200) : std::chrono::minutes(1);
  Clock::time_point last_ = Clock::now();
};

}  // namespace shigusa::app
