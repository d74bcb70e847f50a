// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace shigusa {

// ASCII alone, whatever the locale; the blanks are those of JSON and XML.
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

// With a capital for its first letter, if that is one of ASCII.
[[nodiscard]] inline std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

// A text within an element of HTML or SVG, or an attribute's quotes: markup's own characters are
// escaped, those that it does not allow left out, and bytes that are not UTF-8 replaced.
[[nodiscard]] std::string markup_text(std::string_view text);

// Bytes of the UTF-8 character at the start of a text, 0 where there is none. Overlong forms,
// surrogates and values above U+10FFFF are none: writers of JSON refuse them.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

}  // namespace shigusa
