// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string_view>

// The last failure of each thread. A thread's place for it is made at its first failure; where
// there is no memory for it, the failure is told as that.
namespace shigusa::door {

// Keeps a text, as much of it as has room.
void keep_failure(std::string_view text) noexcept;
// Keeps an error with its text. May throw std::bad_alloc, and then nothing is kept.
void keep_failure(Error error);

// The text of the calling thread's last failure, "" where none failed.
[[nodiscard]] const char* failure_text() noexcept;
// Its error; null of a failure that has its text alone.
[[nodiscard]] const Error* failure_error() noexcept;

}  // namespace shigusa::door
