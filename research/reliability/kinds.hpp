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

// Tasks that ask for the same.
struct Kind {
  const char* name;
  // The task of that number among those of its kind: always the same for the same cast.
  DrawnTask (*draw)(const Cast& cast, std::uint64_t number);
  bool may_be_refused = false;  // a hand may not reach what it is to rest on
};

// All kinds; those of built-in bodies' hands and feet first.
[[nodiscard]] std::span<const Kind> all_kinds();

}  // namespace shigusa::bench
