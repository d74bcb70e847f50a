// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace shigusa::app {

// A range of whole numbers from 0, either end of which may be left out.
struct NumberRange {
  std::optional<std::uint64_t> first{};
  std::optional<std::uint64_t> last{};
};

// The whole number that a text is; none where it is something else.
[[nodiscard]] std::optional<std::uint64_t> parse_whole(std::string_view text);

// "FIRST:LAST", "FIRST:", ":LAST" or ":"; none where it is something else.
[[nodiscard]] std::optional<NumberRange> parse_range(std::string_view text);

}  // namespace shigusa::app
