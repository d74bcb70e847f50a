// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string_view>

// Last failure of each thread. A thread's storage is allocated at its first failure; without
// memory, the failure is reported as out of memory.
namespace shigusa::door {

// Stores a text, cut to the available room.
void keep_failure(std::string_view text) noexcept;
// Stores an error with its text. On std::bad_alloc nothing is stored.
void keep_failure(Error error);

// Text of the calling thread's last failure, "" if there is none.
[[nodiscard]] const char* failure_text() noexcept;
// Error of the last failure; null if it has only a text.
[[nodiscard]] const Error* failure_error() noexcept;

}  // namespace shigusa::door
