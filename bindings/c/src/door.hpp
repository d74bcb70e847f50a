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

// Structs behind the handles of shigusa.h.

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
  // player of the task; kept, as a slider plays it at each step
  mutable std::optional<shigusa::MotionPlayer> player{};
  // [candidate][series] requested tables, made on first use
  mutable std::vector<std::vector<std::vector<double>>> series{};
};

namespace shigusa::door {

// Stores the text of shigusa_message(); returns the status.
shigusa_status refuse(shigusa_status status, const char* message) noexcept;
// Stores also the error for shigusa_failure().
shigusa_status refuse(Error error);
// Status for the exception being handled.
shigusa_status refuse_exception() noexcept;

// Runs `work`, a function of the floating-point scope that returns Result<void>; returns the status
// and lets no exception escape.
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
// The same for a function without arguments.
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

// Copies text for the caller.
Result<void> give(std::string text, shigusa_bytes** bytes);

}  // namespace shigusa::door
