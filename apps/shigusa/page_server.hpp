// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <shigusa/error.hpp>
#include <string_view>
#include <vector>

#include "page.hpp"

struct MHD_Connection;
struct MHD_Daemon;

namespace shigusa::app {

// HTTP server of a page's files for browsers on this machine, with libmicrohttpd. A connection
// takes a few kB of memory and never blocks others, whatever it sends.
class PageServer {
 public:
  explicit PageServer(Page page) : page_(std::move(page)) {}

  // Listens on a port of 127.0.0.1, or on any free port for 0, and answers on a separate thread
  // until the server is destroyed. Fails if the port is taken.
  [[nodiscard]] Result<void> start(int port);
  [[nodiscard]] int port() const;  // once started

 private:
  struct Visit {
    MHD_Connection* connection;
    bool answered = false;
  };
  struct Callbacks;
  struct Stop {
    void operator()(MHD_Daemon* daemon) const;
  };

  void come(MHD_Connection* connection);
  [[nodiscard]] bool answer(MHD_Connection* connection, std::string_view path,
                            std::string_view method);

  Page page_;
  std::vector<Visit> visits_;                 // the oldest first; of the server's thread
  std::unique_ptr<MHD_Daemon, Stop> daemon_;  // last member, as its thread uses the others
};

}  // namespace shigusa::app
