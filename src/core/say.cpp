// SPDX-License-Identifier: MIT
#include "core/say.hpp"

#include <shigusa/error.hpp>

#include "core/check.hpp"

namespace shigusa {
namespace {

// Formats a number by a placeholder such as "{:.2f}"; integers are formatted already.
void write_digits(std::string_view hole, Message& value) {
  if (!value.number || !value.text.empty()) return;
  value.text = fmt::format(fmt::runtime(hole), *value.number);
}

}  // namespace

Message said(const MessageText& sentence, std::vector<Message> values) {
  Message message;
  message.key = sentence.key;
  const std::string_view text = sentence.text;
  std::size_t next = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const bool braces = c == '{' || c == '}';
    if (!braces || text.substr(at, 2) == std::string_view(c == '{' ? "{{" : "}}")) {
      at += braces ? 1 : 0;
      message.text += c;
      continue;
    }
    SHG_CHECK(next < values.size(), "a sentence has a value for each hole");
    const std::size_t end = text.find('}', at);
    Message& value = values[next++];
    write_digits(text.substr(at, end + 1 - at), value);
    message.text += value.text;
    at = end;
  }
  message.values = std::move(values);
  return message;
}

Message Error::to_message() const {
  return place.empty() ? message : say("at_place", place, message);
}

}  // namespace shigusa
