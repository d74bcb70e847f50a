// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <shigusa/error.hpp>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/messages.hpp"

namespace shigusa {

// Lengths as values of a sentence, which a page shows in the unit of the reader's choice. The
// sentence's own text uses metres, or millimetres.
struct Metres {
  double value = 0.0;
};
struct Millimetres {
  double value = 0.0;
};

// Whether a value is a number whose format the placeholder may specify.
template <class Value>
inline constexpr bool kHasDigits =
    std::floating_point<Value> || std::same_as<Value, Metres> || std::same_as<Value, Millimetres>;

// Whether a sentence has as many placeholders as values, with formats for numbers only.
template <class... Values>
[[nodiscard]] consteval bool fits(std::string_view text) {
  constexpr std::size_t kCount = sizeof...(Values);
  constexpr std::array<bool, kCount + 1> kDigits{kHasDigits<std::decay_t<Values>>..., false};
  std::size_t holes = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '{' && text[at] != '}') continue;
    if (at + 1 < text.size() && text[at + 1] == text[at]) {
      ++at;
      continue;
    }
    const std::size_t end = text.find('}', at);
    if (text[at] == '}' || end == text.npos || holes == kCount) return false;
    if (end > at + 1 && !kDigits[holes]) return false;
    ++holes;
    at = end;
  }
  return holes == kCount;
}

// A sentence of the catalogue by its key. Its existence and the types of its placeholders are
// checked at compile time.
template <class... Values>
class Sentence {
 public:
  consteval Sentence(const char* key) : text_(messages::sentence(key)) {
    if (!fits<Values...>(text_.text)) throw std::invalid_argument("the sentence has other holes");
  }
  [[nodiscard]] const MessageText& text() const { return text_; }

 private:
  MessageText text_;
};

// The value of a placeholder before said() formats its number.
[[nodiscard]] inline Message hole_value(Message value) { return value; }
[[nodiscard]] inline Message hole_value(Metres length) {
  Message value;
  value.number = length.value;
  value.unit = "m";
  return value;
}
[[nodiscard]] inline Message hole_value(Millimetres length) {
  Message value;
  value.number = length.value;
  value.unit = "mm";
  return value;
}
template <std::convertible_to<std::string_view> Text>
requires(!std::same_as<Text, Message>) [[nodiscard]] Message hole_value(const Text& text) {
  return Message(std::string_view(text));
}
template <std::floating_point Number>
[[nodiscard]] Message hole_value(Number number) {
  Message value;
  value.number = static_cast<double>(number);
  return value;
}
template <std::integral Number>
[[nodiscard]] Message hole_value(Number number) {
  if constexpr (std::same_as<Number, char>) return Message(std::string_view(&number, 1));
  Message value;
  value.number = static_cast<double>(number);
  value.text = fmt::format("{}", number);
  return value;
}

// The sentence with these values: its text is the result of fmt::format.
[[nodiscard]] Message said(const MessageText& sentence, std::vector<Message> values);

// The message of a sentence of the catalogue: say("load_range", load, most).
template <class... Values>
[[nodiscard]] Message say(Sentence<std::type_identity_t<Values>...> sentence,
                          const Values&... values) {
  std::vector<Message> list;
  list.reserve(sizeof...(values));
  (list.push_back(hole_value(values)), ...);
  return said(sentence.text(), std::move(list));
}

}  // namespace shigusa
