// SPDX-License-Identifier: MIT
#include "page_server.hpp"

#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <strings.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <shigusa/io/file.hpp>
#include <system_error>
#include <utility>

namespace shigusa::app {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// A browser's requests have some hundred bytes, and it opens some ten connections.
constexpr std::size_t kRequestMostBytes = 8192;
constexpr std::size_t kMostConnections = 128;
constexpr auto kTimeToAsk = 5s;
constexpr auto kTimeToTake = 60s;  // the whole answer; a distant browser behind a tunnel is slow
constexpr auto kTimeToFinish = 2s;

// All that the page needs is beside it; 'wasm-unsafe-eval' lets the engine be compiled.
constexpr std::string_view kHeaders =
    "Content-Security-Policy: default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src "
    "'self'; connect-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Cache-Control: no-cache\r\n"
    "Accept-Ranges: none\r\n"
    "Connection: close\r\n";

const char* type_of(const fs::path& file) {
  static constexpr std::array<std::pair<std::string_view, const char*>, 9> kTypes{{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript"},
      {".css", "text/css"},
      {".wasm", "application/wasm"},
      {".json", "application/json"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".ico", "image/x-icon"},
      {".woff2", "font/woff2"},
  }};
  const std::string ending = file.extension().string();
  for (const auto& [known, type] : kTypes) {
    if (ending == known) return type;
  }
  return "application/octet-stream";
}

// The part of `text` before `mark`, which is taken away with it; all of it where there is no mark.
std::string_view take_until(std::string_view& text, std::string_view mark) {
  const std::size_t at = std::min(text.find(mark), text.size());
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(std::min(at + mark.size(), text.size()));
  return part;
}

bool is_same_word(std::string_view a, std::string_view b) {
  return a.size() == b.size() && strncasecmp(a.data(), b.data(), a.size()) == 0;
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

struct RequestLine {
  std::string_view method;
  std::string_view path;  // without what follows a '?'
  bool understood = false;
};

RequestLine parse_request_line(std::string_view line) {
  RequestLine parsed;
  parsed.method = take_until(line, " ");
  std::string_view target = take_until(line, " ");
  parsed.path = take_until(target, "?");
  parsed.understood =
      !parsed.method.empty() && !parsed.path.empty() && (line == "HTTP/1.1" || line == "HTTP/1.0");
  return parsed;
}

struct Reply {
  std::string_view status;
  std::string_view bytes;
  std::string_view type = "text/plain";
};

Error system_error(const char* what, std::string place) {
  return {ErrorCode::io, fmt::format("{}: {}", what, std::generic_category().message(errno)),
          std::move(place)};
}

}  // namespace

Result<Page> read_page(const fs::path& folder) {
  Page page;
  std::size_t bytes = 0;
  std::size_t entries = 0;
  const auto too_much = [&folder] {
    return fail(ErrorCode::invalid_argument,
                fmt::format("holds more than the {} files or {} MB that a built page may have; is "
                            "it the page's folder?",
                            kPageMostEntries, kPageMostBytes >> 20),
                folder.string());
  };
  std::error_code wrong;
  // links to folders are not entered by it
  for (fs::recursive_directory_iterator at(folder, wrong), end; !wrong && at != end;
       at.increment(wrong)) {
    if (++entries > kPageMostEntries) return too_much();
    std::error_code gone;
    if (at->symlink_status(gone).type() != fs::file_type::regular) continue;
    if (at->file_size(gone) > kPageMostBytes - bytes) return too_much();
    Result<std::string> read = read_text_file(at->path(), kPageMostBytes - bytes);
    if (!read) return tl::unexpected(read.error());
    bytes += read->size();
    const std::string path = "/" + at->path().lexically_relative(folder).generic_string();
    page[path] = {type_of(at->path()), std::move(*read)};
  }
  if (wrong) return fail(ErrorCode::io, "cannot be read: " + wrong.message(), folder.string());
  if (!page.contains("/index.html")) {
    return fail(ErrorCode::not_found, "holds no index.html (links are not followed)",
                folder.string());
  }
  return page;
}

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

Result<void> PageServer::listen(int port) {
  const std::string place = fmt::format("port {}", port);
  Descriptor listener(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* const named = reinterpret_cast<sockaddr*>(&address);
  socklen_t size = sizeof address;
  // what was closed a moment ago does not keep its port
  const int yes = 1;
  if (listener.number() < 0 ||
      setsockopt(listener.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) != 0 ||
      bind(listener.number(), named, size) != 0 || ::listen(listener.number(), SOMAXCONN) != 0 ||
      getsockname(listener.number(), named, &size) != 0) {
    return tl::unexpected(system_error("cannot be listened on", place));
  }
  port_ = ntohs(address.sin_port);
  listener_ = std::move(listener);
  return {};
}

Result<void> PageServer::serve(int end) {
  std::vector<pollfd> polled;
  while (true) {
    polled.assign({{end, POLLIN, 0}, {listener_.number(), POLLIN, 0}});
    Clock::time_point next = Clock::now() + kTimeToTake;
    for (const Connection& each : connections_) {
      const short event = each.stage == Stage::answered ? POLLOUT : POLLIN;
      polled.push_back({each.socket.number(), event, 0});
      next = std::min(next, each.deadline);
    }
    const auto patience = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now());
    const int some =
        poll(polled.data(), polled.size(), static_cast<int>(std::max(patience, 0ms).count()));
    if (some < 0 && errno != EINTR) {
      return tl::unexpected(system_error("cannot be waited on", fmt::format("port {}", port_)));
    }
    if (polled[0].revents != 0) return {};
    for (std::size_t k = 0; k < connections_.size(); ++k) {
      if (polled[k + 2].revents != 0) advance(connections_[k]);
    }
    const Clock::time_point now = Clock::now();
    std::erase_if(connections_, [now](const Connection& each) {
      return each.stage == Stage::over || each.deadline <= now;
    });
    if (polled[1].revents != 0) accept_some();
  }
}

// Takes who has come. One who has asked by then is answered at once, so that a crowd that comes
// later cannot take their place before.
void PageServer::accept_some() {
  for (std::size_t k = 0; k < kMostConnections; ++k) {
    Descriptor socket(accept4(listener_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (socket.number() < 0) {
      // another program's descriptors may be all that the system has
      if (errno == EMFILE || errno == ENFILE) make_room();
      return;
    }
    if (connections_.size() >= kMostConnections) make_room();
    advance(connections_.emplace_back(Connection{std::move(socket), Clock::now() + kTimeToAsk}));
  }
}

// Ends the oldest connection that is not being answered, or else the oldest.
void PageServer::make_room() {
  const auto idle =
      std::find_if(connections_.begin(), connections_.end(),
                   [](const Connection& each) { return each.stage != Stage::answered; });
  if (!connections_.empty()) {
    connections_.erase(idle == connections_.end() ? connections_.begin() : idle);
  }
}

void PageServer::advance(Connection& connection) const {
  if (connection.stage == Stage::asking) hear(connection);
  if (connection.stage == Stage::answered) say(connection);
  if (connection.stage == Stage::finishing) finish(connection);
}

void PageServer::hear(Connection& connection) const {
  std::string& request = connection.request;
  const std::size_t known = request.size();
  request.resize(kRequestMostBytes);
  const ssize_t count =
      recv(connection.socket.number(), request.data() + known, request.size() - known, 0);
  request.resize(known + static_cast<std::size_t>(std::max(count, ssize_t{0})));
  if (count <= 0) {
    if (count == 0 || (errno != EAGAIN && errno != EINTR)) connection.stage = Stage::over;
    return;
  }
  constexpr std::string_view kEnd = "\r\n\r\n";
  const std::size_t end = request.find(kEnd, known - std::min(known, kEnd.size() - 1));
  if (end == request.npos && request.size() < kRequestMostBytes) return;
  answer(connection, std::string_view(request).substr(0, end));
  connection.request = {};
}

// `request` is without the empty line at its end, or longer than allowed where none came.
void PageServer::answer(Connection& connection, std::string_view request) const {
  const bool too_long = request.size() == kRequestMostBytes;
  const RequestLine line = parse_request_line(take_until(request, "\r\n"));
  const auto file = page_.find(line.path == "/" ? "/index.html" : line.path);
  Reply reply;
  if (too_long) {
    reply = {"431 Request Header Fields Too Large", "This request is too long.\n"};
  } else if (!line.understood) {
    reply = {"400 Bad Request", "This is no request of HTTP/1.1.\n"};
  } else if (!is_ours(request)) {
    reply = {"421 Misdirected Request", "This server is for this machine alone.\n"};
  } else if (line.method != "GET" && line.method != "HEAD") {
    reply = {"405 Method Not Allowed\r\nAllow: GET, HEAD", "Files can only be read here.\n"};
  } else if (file == page_.end()) {
    reply = {"404 Not Found", "The page has no such file.\n"};
  } else {
    reply = {"200 OK", file->second.bytes, file->second.type};
  }
  connection.head = fmt::format("HTTP/1.1 {}\r\n{}Content-Type: {}\r\nContent-Length: {}\r\n\r\n",
                                reply.status, kHeaders, reply.type, reply.bytes.size());
  if (line.method != "HEAD") connection.body = reply.bytes;
  connection.stage = Stage::answered;
  connection.deadline = Clock::now() + kTimeToTake;
}

// A page of the network that gives its own name this address gets nothing.
bool PageServer::is_ours(std::string_view head) const {
  // browsers leave out the port that is HTTP's own
  const std::string port = port_ == 80 ? "" : fmt::format(":{}", port_);
  int hosts = 0;
  bool ours = false;
  while (!head.empty()) {
    std::string_view value = take_until(head, "\r\n");
    if (!is_same_word(take_until(value, ":"), "Host")) continue;
    const std::string_view host = without_blanks(value);
    ours = host == "127.0.0.1" + port || host == "localhost" + port;
    ++hosts;
  }
  return ours && hosts == 1;
}

void PageServer::say(Connection& connection) const {
  const std::size_t head = connection.head.size();
  while (connection.sent < head + connection.body.size()) {
    const std::string_view rest = connection.sent < head
                                      ? std::string_view(connection.head).substr(connection.sent)
                                      : connection.body.substr(connection.sent - head);
    const ssize_t count = send(connection.socket.number(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (count < 0) {
      if (errno != EAGAIN && errno != EINTR) connection.stage = Stage::over;
      return;
    }
    connection.sent += static_cast<std::size_t>(count);
  }
  // to close at once would throw away what is on its way, if more was sent than was read
  shutdown(connection.socket.number(), SHUT_WR);
  connection.stage = Stage::finishing;
  connection.deadline = Clock::now() + kTimeToFinish;
}

void PageServer::finish(Connection& connection) const {
  std::array<char, 4096> unread;
  const ssize_t count = recv(connection.socket.number(), unread.data(), unread.size(), 0);
  if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) {
    connection.stage = Stage::over;
  }
}

}  // namespace shigusa::app
