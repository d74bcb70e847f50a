// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <shigusa/core/result.hpp>
#include <string>
#include <string_view>
#include <vector>

// Serves a page's files to the browsers of this machine, over HTTP/1.1. Whoever connects takes a
// few kB of memory and a few seconds at most, whatever they send or leave unsent.
namespace shigusa::app {

struct PageFile {
  std::string type;  // as HTTP names it, "text/html"
  std::string bytes;
};

// By the path that is asked for, "/assets/main.js".
using Page = std::map<std::string, PageFile, std::less<>>;

inline constexpr std::size_t kPageMostBytes = std::size_t{64} << 20;
inline constexpr std::size_t kPageMostEntries = 1000;

// All files of a folder and of those in it, read once: what becomes of the folder later is no
// longer served. Links are left out, as they may lead elsewhere. Fails without an index.html, and
// on more files or bytes than a built page has.
[[nodiscard]] Result<Page> read_page(const std::filesystem::path& folder);

// A descriptor that is closed with its owner; -1 is none.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_ = -1;
};

class PageServer {
 public:
  explicit PageServer(Page page) : page_(std::move(page)) {}

  // Listens on a port of 127.0.0.1, or on any that is free for 0; `port()` tells which. Fails where
  // the port is taken.
  [[nodiscard]] Result<void> listen(int port);
  [[nodiscard]] int port() const { return port_; }

  // Answers until the descriptor `end` can be read.
  [[nodiscard]] Result<void> serve(int end);

 private:
  using Clock = std::chrono::steady_clock;

  enum class Stage {
    asking,     // its request is not whole yet
    answered,   // the answer is on its way
    finishing,  // all is sent; what it still sends is thrown away
    over,
  };
  struct Connection {
    Descriptor socket;
    Clock::time_point deadline;
    Stage stage = Stage::asking;
    std::string request{};
    std::string head{};       // of the answer
    std::string_view body{};  // of the answer, in the page
    std::size_t sent = 0;     // bytes of both
  };

  void accept_some();
  void make_room();
  void advance(Connection& connection) const;
  void hear(Connection& connection) const;
  void say(Connection& connection) const;
  void finish(Connection& connection) const;
  void answer(Connection& connection, std::string_view request) const;
  [[nodiscard]] bool is_ours(std::string_view head) const;

  Page page_;
  int port_ = 0;
  Descriptor listener_;
  std::vector<Connection> connections_;  // the oldest first
};

}  // namespace shigusa::app
