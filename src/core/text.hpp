// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace shigusa {

// Whether a character is a blank of JSON and XML. These functions are for ASCII only, whatever the
// locale.
[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}
[[nodiscard]] constexpr bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
[[nodiscard]] constexpr char lower(char c) {
  return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
}
[[nodiscard]] inline std::string lower(std::string text) {
  for (char& c : text) c = lower(c);
  return text;
}

template <class List, class Value>
[[nodiscard]] bool contains(const List& list, const Value& value) {
  return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

// The text with its first letter capitalised, if that is ASCII.
[[nodiscard]] inline std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

// A text for the content of an HTML or SVG element, or for a quoted attribute: markup characters
// are escaped, disallowed ones dropped, and invalid UTF-8 bytes replaced.
[[nodiscard]] std::string markup_text(std::string_view text);

// Number of bytes of the UTF-8 character at the start of a text, 0 if there is none. Overlong
// forms, surrogates and values above U+10FFFF are invalid: writers of JSON reject them.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

}  // namespace shigusa
