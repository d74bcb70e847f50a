// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string_view>

#include "files/json_memory.hpp"

namespace shigusa {

using Json = nlohmann::ordered_json;

// Limits of a file. Walking a tree of unlimited depth overflows the stack; finding a
// member is a search through all of its object's; the parser looks through all of a list when an
// object in it ends; a value takes far more memory than its text.
inline constexpr int kJsonMaxDepth = 32;
inline constexpr std::size_t kJsonMaxMembers = 256;       // of one object
inline constexpr std::size_t kJsonMaxObjects = 2048;      // in one list
inline constexpr std::size_t kJsonMaxValues = 1'000'000;  // a result of 1000 candidates: 200,000

// Parses JSON text. Fails on text that is not JSON (the error tells line and column), that passes
// the limits above, or that has a key twice in one object.
[[nodiscard]] Result<Json> parse_json(std::string_view text, std::string_view name);

}  // namespace shigusa
