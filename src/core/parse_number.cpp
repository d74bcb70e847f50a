// SPDX-License-Identifier: MIT
#include "core/parse_number.hpp"

#include <charconv>
#include <cstdlib>
#include <shigusa/error.hpp>
#include <string>

#include "c_locale.hpp"

namespace shigusa {
namespace {

// Parses as parse_number does, and accepts leading blanks and hexadecimal digits, as strtod does.
std::optional<double> parse_by_strtod(std::string_view text) {
  const std::string copy(text);
  char* stop = nullptr;
  const WithinCLocale point;
  const double value = std::strtod(copy.c_str(), &stop);
  if (copy.empty() || stop != copy.c_str() + copy.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
#ifdef __cpp_lib_to_chars
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, value);
  if (stop != end || status == std::errc::invalid_argument) return std::nullopt;
  if (status == std::errc{}) return value;
    // too large or too small: from_chars does not distinguish them
#else
  // the WebAssembly library has no from_chars for double
  if (text.empty() || text.find_first_of("xX") != text.npos ||
      std::string_view("+ \t\n\v\f\r").find(text.front()) != std::string_view::npos) {
    return std::nullopt;
  }
#endif
  return parse_by_strtod(text);
}

}  // namespace shigusa
