// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>

#include "commands.hpp"
#include "next_step.hpp"

namespace shigusa::app {
namespace {

std::atomic<bool> interrupt_flag{false};

void on_interrupt(int) {
  // the second time, nobody wants to wait for the best so far
  if (interrupt_flag.exchange(true)) _exit(130);
}

}  // namespace

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    // the lowest number that is free is this one; of what cannot be written, writing fails
    (void)!open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
  }
}

void write_out(std::string_view text) {
  // the stream itself remembers that writing failed
  (void)std::fwrite(text.data(), 1, text.size(), stdout);
}

void write_err(std::string_view text) { (void)std::fwrite(text.data(), 1, text.size(), stderr); }

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

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

const std::atomic<bool>& interrupted() { return interrupt_flag; }

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
    print_err("\r{} [{:<{}}] {} motions, best score {:.4f}  ", now.stage,
              std::string(static_cast<std::size_t>(filled), '='), kWidth, now.evaluations,
              now.best_score);
    std::fflush(stderr);
  };
  return progress;
}

void end_progress_line() {
  if (isatty(STDERR_FILENO) != 0) print_err("\r\x1b[K");
}

}  // namespace shigusa::app
