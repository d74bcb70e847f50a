// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "cast.hpp"

namespace shigusa::bench {

// A random task.
struct DrawnTask {
  TaskFile file;
  const CastMember* who = nullptr;  // of one from a file
};

// Tasks with the same kind of request.
struct Kind {
  const char* name;
  // A kind's task of that number, determined by the number and the cast.
  DrawnTask (*draw)(const Cast& cast, std::uint64_t number);
  bool may_be_refused = false;  // a hand may not reach its support
};

// All kinds; those of built-in bodies' hands and feet first.
[[nodiscard]] std::span<const Kind> all_kinds();

}  // namespace shigusa::bench
