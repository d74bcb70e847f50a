// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace shigusa {

// Thrown by SHG_CHECK: the caller broke a documented precondition.
class PreconditionError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace shigusa

// Always on. `message` says which precondition, with the value seen.
#define SHG_CHECK(condition, message)                                                 \
  do {                                                                                \
    if (!(condition))                                                                 \
      throw ::shigusa::PreconditionError(std::string(message) + " [" #condition "]"); \
  } while (false)

// Inner-loop invariants: checked in debug builds only.
#ifdef NDEBUG
#define SHG_ASSERT(condition) ((void)0)
#else
#define SHG_ASSERT(condition) SHG_CHECK(condition, "broken invariant")
#endif
