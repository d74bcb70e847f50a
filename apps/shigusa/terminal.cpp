// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "commands.hpp"
#include "next_step.hpp"

namespace shigusa::app {

void write_out(std::string_view text) {
  // the stream keeps its error state
  (void)std::fwrite(text.data(), 1, text.size(), stdout);
}

void write_err(std::string_view text) { (void)std::fwrite(text.data(), 1, text.size(), stderr); }

std::optional<std::string> InputLines::next(bool wait) {
  for (;;) {
    const std::size_t end = std::min(block_.find('\n', used_), block_.size());
    line_.append(block_, used_, std::min(end - used_, most_ + 1 - line_.size()));
    const bool whole = end < block_.size();
    used_ = whole ? end + 1 : end;
    if (whole) return std::exchange(line_, {});
    if (read_block(wait)) continue;
    if (!ended_ || line_.empty()) return std::nullopt;
    return std::exchange(line_, {});
  }
}

int finish_output(int exit_code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_code;
  print_err("shigusa: cannot write to the standard output\n");
  return kWrongInput;
}

std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '?';
  }
  return result;
}

int exit_code_of(const Result<int>& command) {
  if (command) return *command;
  end_progress_line();
  const Error& error = command.error();
  print_err("shigusa: {}\n", printable(error.to_string() + next_step(error)));
  return kWrongInput;
}

void note(std::string_view place, std::string_view message) {
  print_err("shigusa: {}: note: {}\n", printable(place), printable(message));
}

Progress terminal_progress() {
  Progress progress;
  progress.cancel = &interrupted();
  if (!is_terminal()) return progress;
  using Clock = std::chrono::steady_clock;
  progress.report = [last = Clock::now()](const ProgressReport& now) mutable {
    // a search of a few milliseconds draws nothing
    if (Clock::now() - last < std::chrono::milliseconds(100)) return;
    last = Clock::now();
    constexpr int kWidth = 30;
    const int filled = static_cast<int>(now.fraction * kWidth);
    print_err("\r{} [{:<{}}] {} motions, best score {:.4f}  ", now.stage,
              std::string(static_cast<std::size_t>(filled), '='), kWidth, now.evaluations,
              now.best_score);
    std::fflush(stderr);
  };
  return progress;
}

void end_progress_line() {
  if (is_terminal()) print_err("\r\x1b[K");
}

}  // namespace shigusa::app
