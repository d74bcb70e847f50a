// SPDX-License-Identifier: MIT
#include "page_server.hpp"

#include <fmt/format.h>
#include <microhttpd.h>
#include <netinet/in.h>
#include <strings.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace shigusa::app {
namespace {

// Limits: a browser's request has some hundred bytes, and it opens some ten connections.
constexpr std::size_t kMemoryOfConnection = 16384;
constexpr unsigned kMostConnections = 128;
constexpr unsigned kTimeToAsk = 5;    // s
constexpr unsigned kTimeToTake = 60;  // s without a byte taken: behind a tunnel

// Content policy: all resources are local; 'wasm-unsafe-eval' permits compiling the engine.
constexpr std::pair<const char*, const char*> kHeaders[] = {
    {"Content-Security-Policy",
     "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src "
     "'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; base-uri 'none'; "
     "form-action 'none'; frame-ancestors 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Accept-Ranges", "none"},
    {"Connection", "close"},
};

struct Reply {
  unsigned status;
  std::string_view bytes;
  const char* type = "text/plain";
  const char* cache = "no-cache";
};

// Names of these files contain a hash of their contents, so browsers may cache them.
constexpr std::string_view kLasting = "/assets/";

struct Hosts {
  int count = 0;
  std::string last;
};

MHD_Result note_host(void* hosts, MHD_ValueKind, const char* key, const char* value) {
  if (strcasecmp(key, "Host") == 0) {
    auto& known = *static_cast<Hosts*>(hosts);
    ++known.count;
    known.last = value == nullptr ? "" : value;
  }
  return MHD_YES;
}

// Refuses other host names, so that a foreign page whose name resolves to this address gets
// nothing.
bool is_ours(MHD_Connection* connection) {
  Hosts hosts;
  MHD_get_connection_values(connection, MHD_HEADER_KIND, &note_host, &hosts);
  MHD_Daemon* const daemon =
      MHD_get_connection_info(connection, MHD_CONNECTION_INFO_DAEMON)->daemon;
  const int number = MHD_get_daemon_info(daemon, MHD_DAEMON_INFO_BIND_PORT)->port;
  // browsers leave out the default port of HTTP
  const std::string port = number == 80 ? "" : fmt::format(":{}", number);
  return hosts.count == 1 && (hosts.last == "127.0.0.1" + port || hosts.last == "localhost" + port);
}

}  // namespace

// Callbacks of libmicrohttpd, on the server's thread.
struct PageServer::Callbacks {
  static MHD_Result answer(void* server, MHD_Connection* connection, const char* path,
                           const char* method, const char*, const char*, std::size_t*, void**) {
    return static_cast<PageServer*>(server)->answer(connection, path, method) ? MHD_YES : MHD_NO;
  }

  static void notify(void* server, MHD_Connection* connection, void**,
                     MHD_ConnectionNotificationCode what) {
    auto* const own = static_cast<PageServer*>(server);
    if (what == MHD_CONNECTION_NOTIFY_STARTED) {
      own->come(connection);
    } else {
      std::erase_if(own->visits_, [=](const Visit& each) { return each.connection == connection; });
    }
  }
};

void PageServer::Stop::operator()(MHD_Daemon* daemon) const { MHD_stop_daemon(daemon); }

Result<void> PageServer::start(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  errno = 0;
  daemon_.reset(MHD_start_daemon(
      MHD_USE_AUTO_INTERNAL_THREAD, 0, nullptr, nullptr, &Callbacks::answer, this,
      MHD_OPTION_SOCK_ADDR, &address, MHD_OPTION_NOTIFY_CONNECTION, &Callbacks::notify, this,
      // more than are kept, so that new connections are always accepted
      MHD_OPTION_CONNECTION_LIMIT, 2 * kMostConnections, MHD_OPTION_CONNECTION_MEMORY_LIMIT,
      kMemoryOfConnection, MHD_OPTION_CONNECTION_TIMEOUT, kTimeToAsk, MHD_OPTION_END));
  if (!daemon_) {
    return fail(ErrorCode::io, "cannot be listened on: " + std::generic_category().message(errno),
                fmt::format("port {}", port));
  }
  return {};
}

int PageServer::port() const {
  return MHD_get_daemon_info(daemon_.get(), MHD_DAEMON_INFO_BIND_PORT)->port;
}

// Replaces the oldest idle connection, or else the oldest one, by a new one.
void PageServer::come(MHD_Connection* connection) {
  if (visits_.size() == kMostConnections) {
    const auto idle = std::find_if(visits_.begin(), visits_.end(),
                                   [](const Visit& each) { return !each.answered; });
    const auto leaving = idle == visits_.end() ? visits_.begin() : idle;
    const auto* info =
        MHD_get_connection_info(leaving->connection, MHD_CONNECTION_INFO_CONNECTION_FD);
    // the library has no word for it, and takes this as the other side's end
    shutdown(info->connect_fd, SHUT_RDWR);
    visits_.erase(leaving);
  }
  visits_.push_back({connection});
}

bool PageServer::answer(MHD_Connection* connection, std::string_view path,
                        std::string_view method) {
  const auto file = page_.find(path == "/" ? "/index.html" : path);
  Reply reply;
  if (!is_ours(connection)) {
    reply = {MHD_HTTP_MISDIRECTED_REQUEST, "This server is for this machine alone.\n"};
  } else if (method != "GET" && method != "HEAD") {
    reply = {MHD_HTTP_METHOD_NOT_ALLOWED, "Files can only be read here.\n"};
  } else if (file == page_.end()) {
    reply = {MHD_HTTP_NOT_FOUND, "The page has no such file.\n"};
  } else {
    reply = {MHD_HTTP_OK, file->second.bytes, file->second.type.c_str()};
    if (path.starts_with(kLasting)) reply.cache = "max-age=31536000, immutable";
  }
  const auto destroy = [](MHD_Response* response) { MHD_destroy_response(response); };
  const std::unique_ptr<MHD_Response, decltype(destroy)> response(
      MHD_create_response_from_buffer(reply.bytes.size(), const_cast<char*>(reply.bytes.data()),
                                      MHD_RESPMEM_PERSISTENT),
      destroy);
  if (!response) return false;
  for (const auto& [name, value] : kHeaders) {
    MHD_add_response_header(response.get(), name, value);
  }
  MHD_add_response_header(response.get(), "Content-Type", reply.type);
  MHD_add_response_header(response.get(), "Cache-Control", reply.cache);
  if (reply.status == MHD_HTTP_METHOD_NOT_ALLOWED) {
    MHD_add_response_header(response.get(), "Allow", "GET, HEAD");
  }
  for (Visit& each : visits_) each.answered |= each.connection == connection;
  MHD_set_connection_option(connection, MHD_CONNECTION_OPTION_TIMEOUT, kTimeToTake);
  return MHD_queue_response(connection, reply.status, response.get()) == MHD_YES;
}

}  // namespace shigusa::app
