// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdio>
#include <string_view>

#include "commands.hpp"

namespace shigusa::app {

// Progress line on stderr: redrawn on a terminal, and once a minute elsewhere, as in a job's log.
class PacedLine {
 public:
  // Whether the next line is due, to avoid formatting it otherwise.
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
