// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa.h>

#include <atomic>
#include <exception>
#include <shigusa/run.hpp>

#include "arithmetic.hpp"

namespace shigusa::door {

// An exception thrown by the host's own function.
struct HostFault {
  std::exception_ptr thrown;  // null for an exception that is not of C++
};

// Progress callback of the caller, which can stop a search. It runs on the calling thread, in the
// host's floating-point environment; its exceptions do not pass through the search, which is
// cancelled.
class Watched {
 public:
  Watched(const shigusa_watch* watch, const OwnArithmetic& arithmetic)
      : watch_(watch), arithmetic_(&arithmetic) {}
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

  [[nodiscard]] Progress progress();
  // Calls a function of the host, bool(), in the host's floating-point environment; false, and the
  // search ends, if it returns false or throws.
  template <class Call>
  bool ask(const Call& call) noexcept {
    if (failed_) return false;
    try {
      const HostArithmetic host(arithmetic_->host());
      if (call()) return true;
      stop_ = true;
    } catch (...) {
      failed_ = true;
      thrown_ = std::current_exception();
      stop_ = true;
    }
    return false;
  }
  // Throws a HostFault if the host's function threw.
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
