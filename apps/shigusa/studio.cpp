// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "commands.hpp"
#include "page_server.hpp"

namespace shigusa::app {
namespace {

namespace fs = std::filesystem;

// The folder of the page's built files: the user's, the one installed beside the program, or the
// source tree's.
Result<fs::path> page_folder(const std::string& given) {
  if (!given.empty()) return given;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  for (const fs::path& folder : {program.parent_path().parent_path() / "share/shigusa/studio",
                                 fs::path(SHIGUSA_STUDIO_BUILT)}) {
    if (fs::is_regular_file(folder / "index.html", ignored)) return folder;
  }
  return fail(ErrorCode::not_found,
              "the page is not built: run scripts/build_studio, or tell its folder by --folder",
              "studio");
}

// Shows the page in the person's browser; where that cannot be done they have the address. Nobody
// waits for the opener's end: the system clears it away with the studio.
void open_browser(std::string address) {
  std::string opener = "xdg-open";
  char* const arguments[] = {opener.data(), address.data(), nullptr};
  // it shall hear the signals that are blocked here
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

// Ctrl-C and kill no longer end the program, or a thread that starts later, but can be waited for.
sigset_t blocked_ends() {
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);
  return ends;
}

}  // namespace

Result<int> studio(const StudioOptions& options) {
  SHG_TRY_ASSIGN(const fs::path folder, page_folder(options.folder));
  SHG_TRY_ASSIGN(Page page, read_page(folder));
  const sigset_t ends = blocked_ends();
  PageServer server(std::move(page));
  SHG_TRY(server.start(options.port));
  const std::string address = fmt::format("http://127.0.0.1:{}/", server.port());
  print_out("{}\n", address);
  std::fflush(stdout);
  print_err("shigusa studio: open this address; Ctrl-C ends it\n");
  if (options.open) open_browser(address);
  int end = 0;
  sigwait(&ends, &end);
  return kDone;
}

}  // namespace shigusa::app
