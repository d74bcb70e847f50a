// SPDX-License-Identifier: MIT
#include "number_range.hpp"

#include <charconv>
#include <system_error>

namespace shigusa::app {

std::optional<std::uint64_t> parse_whole(std::string_view text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value);
  if (code != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<NumberRange> parse_range(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == text.npos) return std::nullopt;
  const std::string_view first = text.substr(0, colon);
  const std::string_view last = text.substr(colon + 1);
  const NumberRange range{parse_whole(first), parse_whole(last)};
  if (range.first.has_value() == first.empty() || range.last.has_value() == last.empty()) {
    return std::nullopt;
  }
  return range;
}

}  // namespace shigusa::app
