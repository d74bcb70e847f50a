// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa.h>

#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/shigusa.hpp>
#include <string>
#include <utility>
#include <vector>

#include "arithmetic.hpp"

// The structs behind the handles of shigusa.h.

struct shigusa_bytes {
  std::string text;
};

struct shigusa_character {
  shigusa::CharacterSpec spec;  // measured
};

struct shigusa_result {
  shigusa::TaskFile file;
  shigusa::Task task;
  shigusa::GenerateResult generation;
  shigusa::RunInfo info;
  // of the task; kept, since a slider plays it at each step
  mutable std::optional<shigusa::MotionPlayer> player{};
  // [candidate][series] tables that were asked for, made at the first time
  mutable std::vector<std::vector<std::vector<double>>> series{};
};

namespace shigusa::door {

// Keeps the text of shigusa_message(), and returns the status of it.
shigusa_status refuse(shigusa_status status, const char* message) noexcept;
// The same, and keeps the error for shigusa_failure().
shigusa_status refuse(Error error);
// The status of the exception that is being handled.
shigusa_status refuse_exception() noexcept;

// The status of `work`, a function of the arithmetic that it runs in to Result<void>: no exception
// leaves it.
template <class Work>
shigusa_status guarded_watched(Work&& work) noexcept {
  const OwnArithmetic arithmetic;
  try {
    Result<void> done = work(arithmetic);
    return done ? SHIGUSA_OK : refuse(std::move(done).error());
  } catch (...) {
    return refuse_exception();
  }
}
// The same of a function of nothing.
template <class Work>
shigusa_status guarded(Work&& work) noexcept {
  return guarded_watched([&work](const OwnArithmetic&) { return work(); });
}

// Refuses null pointers by name.
template <class Pointer, class... More>
bool any_null(const char** name, const char* first_name, Pointer first, More... more) {
  if (first == nullptr) {
    *name = first_name;
    return true;
  }
  if constexpr (sizeof...(more) > 0) return any_null(name, more...);
  return false;
}
template <class... Pointers>
Result<void> need(Pointers... named) {
  const char* name = nullptr;
  if (!any_null(&name, named...)) return {};
  return fail(ErrorCode::invalid_argument, std::string(name) + " is null");
}

// Gives text to the caller.
Result<void> give(std::string text, shigusa_bytes** bytes);

}  // namespace shigusa::door
