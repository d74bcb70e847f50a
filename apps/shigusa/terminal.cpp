// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>

#include "commands.hpp"

namespace shigusa::app {
namespace {

std::atomic<bool> interrupt_flag{false};

void on_interrupt(int) {
  // the second time, nobody wants to wait for the best so far
  if (interrupt_flag.exchange(true)) _exit(130);
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '?';
  }
  return result;
}

int report(const Error& error) {
  end_progress_line();
  fmt::print(stderr, "shigusa: {}\n", printable(error.to_string()));
  return kWrongInput;
}

void note(std::string_view place, std::string_view message) {
  fmt::print(stderr, "shigusa: {}: note: {}\n", printable(place), printable(message));
}

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

Progress terminal_progress() {
  Progress progress;
  progress.cancel = &interrupt_flag;
  if (isatty(STDERR_FILENO) == 0) return progress;
  using Clock = std::chrono::steady_clock;
  progress.report = [last = Clock::now()](const ProgressReport& now) mutable {
    // a search of a few milliseconds draws nothing
    if (Clock::now() - last < std::chrono::milliseconds(100)) return;
    last = Clock::now();
    constexpr int kWidth = 30;
    const int filled = static_cast<int>(now.fraction * kWidth);
    fmt::print(stderr, "\r{} [{:<{}}] {} motions, best score {:.4f}  ", now.stage,
               std::string(static_cast<std::size_t>(filled), '='), kWidth, now.evaluations,
               now.best_score);
    std::fflush(stderr);
  };
  return progress;
}

void end_progress_line() {
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace shigusa::app
