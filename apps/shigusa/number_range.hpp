// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace shigusa::app {

// A range of non-negative whole numbers; either end is optional.
struct NumberRange {
  std::optional<std::uint64_t> first{};
  std::optional<std::uint64_t> last{};
};

// Whole number of a text; empty if malformed.
[[nodiscard]] std::optional<std::uint64_t> parse_whole(std::string_view text);

// Parses "FIRST:LAST", "FIRST:", ":LAST" or ":"; empty if malformed.
[[nodiscard]] std::optional<NumberRange> parse_range(std::string_view text);

}  // namespace shigusa::app
