// SPDX-License-Identifier: MIT
#include "node_names.hpp"

#include "core/text.hpp"

namespace shigusa {
namespace {

// Readers of BVH use the rest of a line, trimmed, as the name.
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
