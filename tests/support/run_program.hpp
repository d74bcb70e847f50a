// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/check.hpp"

// Runs the command-line tool and captures its output.
namespace shigusa::testing_support {

struct RunSettings {
  std::filesystem::path folder = ".";  // where the program is started
  // the program's cache; by default a folder that cannot be made
  std::filesystem::path cache = "/dev/null/cache";
  std::filesystem::path input = "/dev/null";  // full path of the standard input
  bool terminal = false;                      // stderr is a terminal
  // SIGINT comes this long after the start
  std::optional<std::chrono::milliseconds> interrupt_after = {};
};

struct ProgramRun {
  int exit_code = -1;  // 128 + the signal if one ended it, as in a shell
  std::string out;
  std::string err;
};

// Path of the program: this build's, or that of SHIGUSA_PROGRAM, by which scripts/check runs these
// tests with a sanitized program.
inline std::string shigusa_program() {
  const char* other = getenv("SHIGUSA_PROGRAM");
  return other != nullptr ? other : SHIGUSA_BINARY;
}

// False in a bare root folder without pseudo-terminals.
inline bool has_terminals() {
  const int end = posix_openpt(O_RDWR | O_NOCTTY);
  const bool usable = end >= 0 && grantpt(end) == 0 && unlockpt(end) == 0;
  if (end >= 0) close(end);
  return usable;
}

// Both ends of a channel that the program writes to: a pipe or a pseudo-terminal.
struct Channel {
  int read_end = -1;
  int write_end = -1;

  explicit Channel(bool terminal) {
    if (terminal) {
      read_end = posix_openpt(O_RDWR | O_NOCTTY);
      SHG_CHECK(read_end >= 0 && grantpt(read_end) == 0 && unlockpt(read_end) == 0, "a terminal");
      write_end = open(ptsname(read_end), O_RDWR | O_NOCTTY);
    } else {
      int ends[2];
      SHG_CHECK(pipe(ends) == 0, "a pipe");
      read_end = ends[0];
      write_end = ends[1];
    }
    fcntl(read_end, F_SETFD, FD_CLOEXEC);
  }

  // False at the end of the program's output.
  bool read_into(std::string& text) const {
    char block[4096];
    const ssize_t count = read(read_end, block, sizeof block);
    if (count > 0) text.append(block, static_cast<std::size_t>(count));
    return count > 0;
  }
};

// Starts the program with its output and messages connected to the channels.
inline pid_t start_shigusa(const std::vector<std::string>& arguments, const RunSettings& settings,
                           const Channel& out, const Channel& err) {
  const std::string program = shigusa_program();
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  SHG_CHECK(child >= 0, "a process");
  if (child == 0) {
    const int input = open(settings.input.c_str(), O_RDONLY);
    if (chdir(settings.folder.c_str()) == 0 &&
        setenv("SHIGUSA_CACHE", settings.cache.c_str(), 1) == 0 && dup2(input, 0) >= 0 &&
        dup2(out.write_end, 1) >= 0 && dup2(err.write_end, 2) >= 0) {
      execv(program.c_str(), argv.data());
    }
    _exit(127);
  }
  close(out.write_end);
  close(err.write_end);
  return child;
}

// Reads both channels to their ends, and closes them.
inline void read_to_end(const Channel& out, const Channel& err, ProgramRun& run) {
  pollfd channels[] = {{out.read_end, POLLIN, 0}, {err.read_end, POLLIN, 0}};
  while (channels[0].fd >= 0 || channels[1].fd >= 0) {
    poll(channels, 2, -1);
    if (channels[0].revents != 0 && !out.read_into(run.out)) channels[0].fd = -1;
    if (channels[1].revents != 0 && !err.read_into(run.err)) channels[1].fd = -1;
  }
  close(out.read_end);
  close(err.read_end);
}

inline ProgramRun run_shigusa(const std::vector<std::string>& arguments,
                              const RunSettings& settings = {}) {
  const Channel out(false);
  const Channel err(settings.terminal);
  const pid_t child = start_shigusa(arguments, settings, out, err);
  std::thread interrupt;
  if (settings.interrupt_after) {
    interrupt = std::thread([&] {
      std::this_thread::sleep_for(*settings.interrupt_after);
      kill(child, SIGINT);
    });
  }
  ProgramRun run;
  read_to_end(out, err, run);
  // the number stays the child's until it is waited for
  if (interrupt.joinable()) interrupt.join();
  int status = 0;
  waitpid(child, &status, 0);
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return run;
}

}  // namespace shigusa::testing_support
