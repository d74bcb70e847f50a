// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <httplib.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <thread>

#include "commands.hpp"

namespace shigusa::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLoopback = "127.0.0.1";
constexpr std::size_t kMostRequestBytes = 4096;  // nothing is sent here

// All that the page needs is beside it; 'wasm-unsafe-eval' lets the engine be compiled.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src "
    "'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; base-uri "
    "'none'; form-action 'none'; frame-ancestors 'none'";

// Where the page's built files are: as told, installed beside the program, or in the source tree.
Result<fs::path> page_folder(const std::string& told) {
  std::error_code ignored;
  std::vector<fs::path> folders;
  if (!told.empty()) {
    folders.emplace_back(told);
  } else {
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    folders.push_back(program.parent_path().parent_path() / "share/shigusa/studio");
    folders.emplace_back(SHIGUSA_STUDIO_BUILT);
  }
  for (const fs::path& folder : folders) {
    if (fs::is_regular_file(folder / "index.html", ignored)) return folder;
  }
  return fail(ErrorCode::not_found,
              told.empty() ? "the page is not built: run scripts/build_studio, or tell its folder "
                             "by --folder"
                           : "holds no index.html",
              told.empty() ? "studio" : "--folder " + told);
}

void set_up(httplib::Server& server, const int& port) {
  server.set_payload_max_length(kMostRequestBytes);
  // by itself it would share a port that another program listens on
  server.set_socket_options([](int socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.set_default_headers({{"Content-Security-Policy", kPolicy},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Referrer-Policy", "no-referrer"},
                              {"Cross-Origin-Opener-Policy", "same-origin"},
                              {"Cross-Origin-Resource-Policy", "same-origin"},
                              {"Cache-Control", "no-cache"}});
  // a page of the network that gives its own name this address gets nothing
  server.set_pre_routing_handler(
      [&port](const httplib::Request& request, httplib::Response& response) {
        const std::string host = request.get_header_value("Host");
        for (const char* name : {kLoopback, "localhost"}) {
          if (host == fmt::format("{}:{}", name, port))
            return httplib::Server::HandlerResponse::Unhandled;
        }
        response.status = 421;
        response.set_content("This server is for this machine alone.\n", "text/plain");
        return httplib::Server::HandlerResponse::Handled;
      });
}

// Shows the page in the person's browser; where that cannot be done they have the address.
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
  const int failed = posix_spawnp(&child, opener.c_str(), nullptr, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  if (failed != 0) return;
  std::thread([child] { waitpid(child, nullptr, 0); }).detach();
}

}  // namespace

int studio(const StudioOptions& options) {
  const Result<fs::path> folder = page_folder(options.folder);
  if (!folder) return report(folder.error());
  // Ctrl-C and kill are waited for by a thread; the server's inherit that they are blocked
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);

  httplib::Server server;
  int port = options.port;
  set_up(server, port);
  if (!server.set_mount_point("/", folder->string())) {
    return report({ErrorCode::io, "cannot be served", folder->string()});
  }
  if (port == 0) {
    port = server.bind_to_any_port(kLoopback);
  } else if (!server.bind_to_port(kLoopback, port)) {
    port = -1;
  }
  if (port < 0) {
    return report({ErrorCode::io, "is taken by another program, or not allowed",
                   fmt::format("port {}", options.port)});
  }
  const std::string address = fmt::format("http://{}:{}/", kLoopback, port);
  fmt::print("{}\n", address);
  std::fflush(stdout);
  fmt::print(stderr, "shigusa studio: open this address; Ctrl-C ends it\n");
  std::thread waiting([&server, ends] {
    int which = 0;
    sigwait(&ends, &which);
    server.stop();
  });
  if (options.open) open_browser(address);
  const bool served = server.listen_after_bind();
  if (!served) kill(getpid(), SIGTERM);  // nobody has asked for the end: let the thread go
  waiting.join();
  return served ? kDone : report({ErrorCode::io, "cannot be listened on", address});
}

}  // namespace shigusa::app
