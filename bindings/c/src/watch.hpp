// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa.h>

#include <atomic>
#include <exception>
#include <shigusa/run.hpp>

#include "arithmetic.hpp"

namespace shigusa::door {

// An exception that came out of the host's own function.
struct HostFault {
  std::exception_ptr thrown;  // none where it is no exception of C++
};

// How the caller watches a search, and stops it. Its function runs on the thread that called, in
// the host's own arithmetic; what it throws does not pass through the search, which ends.
class Watched {
 public:
  Watched(const shigusa_watch* watch, const OwnArithmetic& arithmetic)
      : watch_(watch), arithmetic_(&arithmetic) {}
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

  [[nodiscard]] Progress progress();
  // Throws a HostFault where the host's function threw.
  void pass_on() const {
    if (failed_) throw HostFault{thrown_};
  }

 private:
  void tell(const ProgressReport& report) noexcept;

  const shigusa_watch* watch_;
  const OwnArithmetic* arithmetic_;
  std::atomic<bool> stop_{false};
  bool failed_ = false;
  std::exception_ptr thrown_;
};

}  // namespace shigusa::door
