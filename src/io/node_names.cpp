// SPDX-License-Identifier: MIT
#include "node_names.hpp"

#include <cstdint>

namespace shigusa {
namespace {

// Length of the UTF-8 character at the start of `text`, 0 where there is none. Overlong forms,
// surrogates and values above U+10FFFF are none: writers of JSON refuse them.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool surrogate = first == 0xED && byte(1) > 0x9F;
  const bool beyond = first == 0xF4 && byte(1) > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

// Readers of BVH take the rest of a line for a name, without the blanks around it.
std::string_view trimmed(std::string_view name) {
  while (name.starts_with(' ')) name.remove_prefix(1);
  while (name.ends_with(' ')) name.remove_suffix(1);
  return name;
}

std::string cleaned(std::string_view name) {
  std::string clean;
  name = trimmed(name);
  while (!name.empty()) {
    const std::size_t length = utf8_length(name);
    const char c = name[0];
    const bool control = (c >= 0 && c < ' ') || c == 0x7F;
    const bool refused = length == 0 || control || c == '{' || c == '}';
    const std::size_t used = length == 0 ? 1 : length;
    if (clean.size() + used > kNodeNameBytes) break;
    if (refused) {
      clean += '_';
    } else {
      clean += name.substr(0, used);
    }
    name.remove_prefix(used);
  }
  return clean.empty() ? "joint" : std::string(trimmed(clean));
}

}  // namespace

std::string NodeNames::take(std::string_view name) {
  const std::string clean = cleaned(name);
  std::string unique = clean;
  while (!taken_.emplace(unique, 1).second) {
    unique = clean + '_' + std::to_string(++taken_[clean]);
  }
  return unique;
}

}  // namespace shigusa
