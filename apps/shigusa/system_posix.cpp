// SPDX-License-Identifier: MIT
// Calls of the operating system: streams, signals, programs and libraries.
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>

#include "commands.hpp"

namespace shigusa::app {
namespace {

std::atomic<bool> interrupt_flag{false};

void on_interrupt(int) {
  // a second Ctrl-C gives up waiting for the best motion so far
  if (interrupt_flag.exchange(true)) _exit(130);
}

// Ctrl-C and kill.
sigset_t ends() {
  sigset_t all;
  sigemptyset(&all);
  sigaddset(&all, SIGINT);
  sigaddset(&all, SIGTERM);
  return all;
}

}  // namespace

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    // this takes the lowest free number; writing to a read-only descriptor fails
    (void)!open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
  }
}

bool InputLines::read_block(bool wait) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  while (!ended_) {
    const int ready = poll(&input, 1, wait ? -1 : 0);
    if (ready == 0 || interrupt_flag) return false;
    if (ready < 0) continue;  // another signal
    constexpr std::size_t kBlock = 1 << 16;
    block_.resize(kBlock);
    const ssize_t count = read(STDIN_FILENO, block_.data(), kBlock);
    block_.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    used_ = 0;
    if (count > 0) return true;
    ended_ = count == 0 || errno != EINTR;
  }
  return false;
}

char** utf8_arguments(int&, char** arguments) { return arguments; }

bool is_terminal() { return isatty(STDERR_FILENO) != 0; }

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

const std::atomic<bool>& interrupted() { return interrupt_flag; }

void block_ends() {
  const sigset_t all = ends();
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

void wait_for_end() {
  const sigset_t all = ends();
  int end = 0;
  sigwait(&all, &end);
}

std::filesystem::path program_path() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

void* find_function(const char* library, const char* name) {
  void* const loaded = dlopen(library, RTLD_NOW);
  return loaded != nullptr ? dlsym(loaded, name) : nullptr;
}

void open_browser(std::string address) {
  std::string opener = "xdg-open";
  char* const arguments[] = {opener.data(), address.data(), nullptr};
  // the child must receive the signals that are blocked here
  posix_spawnattr_t attributes;
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t child = 0;
  posix_spawnp(&child, opener.c_str(), nullptr, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
}

}  // namespace shigusa::app
