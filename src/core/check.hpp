// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>

namespace shigusa {

// Throws PreconditionError with "message [condition]". Not inline: a check in the kernel must not
// bring standard library code into files compiled for a SIMD set.
[[noreturn]] void fail_check(const char* message, const char* condition);
[[noreturn]] void fail_check(const std::string& message, const char* condition);

}  // namespace shigusa

// A check in all builds. `message` states the precondition, with the value seen.
#define SHG_CHECK(condition, message)                             \
  do {                                                            \
    if (!(condition)) ::shigusa::fail_check(message, #condition); \
  } while (false)

// A check of inner-loop invariants, in debug builds only.
#ifdef NDEBUG
#define SHG_ASSERT(condition) ((void)0)
#else
#define SHG_ASSERT(condition) SHG_CHECK(condition, "broken invariant")
#endif
