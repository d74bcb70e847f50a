// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string_view>

#include "files/json_memory.hpp"

namespace shigusa {

using Json = nlohmann::ordered_json;

// Limits of a file. Recursion into a tree of unlimited depth overflows the stack; lookup of a
// member is linear in its object's size; the parser scans a whole list when an object in it ends; a
// value takes far more memory than its text.
inline constexpr int kJsonMaxDepth = 32;
inline constexpr std::size_t kJsonMaxMembers = 256;       // of one object
inline constexpr std::size_t kJsonMaxObjects = 2048;      // in one list
inline constexpr std::size_t kJsonMaxValues = 1'000'000;  // a result of 1000 candidates: 200,000

// Parses JSON text. Fails on malformed text (with line and column), on text beyond the limits
// above, and on repeated keys in an object.
[[nodiscard]] Result<Json> parse_json(std::string_view text, std::string_view name);

}  // namespace shigusa
