// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shigusa {

/// A sentence for a person: in English, and as the key and values by which a page words it in
/// another language. A value is a Message as well: a number, a sentence, or a text such as a name
/// from a file, which stays as it is.
struct Message {
  Message() = default;                                       ///< says nothing
  Message(std::string words) : text(std::move(words)) {}     ///< a text without a key
  Message(std::string_view words) : text(words) {}           ///< a text without a key
  Message(const char* words) : text(words) {}                ///< a text without a key
  operator const std::string&() const { return text; }       ///< in English
  [[nodiscard]] bool empty() const { return text.empty(); }  ///< says nothing

  std::string text;              ///< in English; of a number its digits within the sentence
  std::string_view key;          ///< of the engine's sentence (shigusa_facts); empty of others
  std::vector<Message> values;   ///< of such a sentence, in the order of its holes
  std::optional<double> number;  ///< of a number, in `unit`
  std::string_view unit;         ///< of a number that is a length, "m" or "mm"; else empty

  /// Whether the English texts are the same; then the values are.
  friend bool operator==(const Message& a, const Message& b) { return a.text == b.text; }
  /// Whether that is the English text.
  template <std::convertible_to<std::string_view> Text>
  requires(!std::same_as<Text, Message>) friend bool operator==(const Message& a, const Text& b) {
    return a.text == std::string_view(b);
  }
};

}  // namespace shigusa
