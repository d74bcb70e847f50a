// SPDX-License-Identifier: MIT
#include "json_splice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "files/json_memory.hpp"

namespace shigusa {
namespace {

// Key decoded from a quoted text, escapes included.
std::string key_of(std::string_view quoted) {
  if (quoted.size() < 2) return {};
  if (quoted.find('\\') == quoted.npos) return std::string(quoted.substr(1, quoted.size() - 2));
  const nlohmann::json key = nlohmann::json::parse(quoted, nullptr, false);
  return key.is_string() ? key.get<std::string>() : std::string();
}

}  // namespace

std::string json_quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_numbers(std::initializer_list<double> values) {
  return fmt::format("[{}]", fmt::join(values, ","));
}

JsonSplice::JsonSplice(std::string_view text) : text_(text) {}

std::size_t JsonSplice::skip_blanks(std::size_t at) const {
  while (at < text_.size() && is_blank(text_[at])) ++at;
  return at;
}

std::size_t JsonSplice::after_mark(std::size_t at) const {
  return std::min(skip_blanks(at) + 1, text_.size());
}

std::size_t JsonSplice::end_of_value(std::size_t at) const {
  std::size_t depth = 0;
  for (; at < text_.size(); ++at) {
    const char c = text_[at];
    if (c == '"') {
      for (++at; at < text_.size() && text_[at] != '"'; ++at) {
        if (text_[at] == '\\') ++at;
      }
      if (depth == 0) return std::min(at + 1, text_.size());
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if (c == '}' || c == ']') {
      if (depth == 0) return at;  // end of a number
      if (--depth == 0) return at + 1;
    } else if (depth == 0 && (c == ',' || is_blank(c))) {
      return at;
    }
  }
  return text_.size();
}

JsonSplice::Value JsonSplice::root() const {
  const std::size_t begin = text_.find('{');  // a byte order mark may stand before it
  if (begin == text_.npos) return {};
  return {begin, end_of_value(begin), begin};
}

std::string_view JsonSplice::text_of(const Value& value) const {
  return text_.substr(value.begin, value.end - value.begin);
}

JsonSplice::Value JsonSplice::member(const Value& object, std::string_view key) const {
  Value found;
  if (!object || text_[object.begin] != '{') return found;
  std::size_t at = skip_blanks(object.begin + 1);
  while (at < object.end && text_[at] == '"') {
    const std::size_t key_end = end_of_value(at);
    const std::size_t begin = skip_blanks(after_mark(key_end));
    const std::size_t end = end_of_value(begin);
    if (key_of(text_.substr(at, key_end - at)) == key) found = {begin, end, at};
    at = skip_blanks(after_mark(end));
  }
  return found;
}

template <class Action>
void JsonSplice::each(const Value& list, Action&& action) const {
  if (!list || text_[list.begin] != '[') return;
  std::size_t at = skip_blanks(list.begin + 1);
  while (at < list.end && text_[at] != ']') {
    const std::size_t end = end_of_value(at);
    action(Value{at, end, at});
    at = skip_blanks(after_mark(end));
  }
}

std::vector<JsonSplice::Value> JsonSplice::elements(const Value& list) const {
  std::vector<Value> found;
  each(list, [&](const Value& value) {
    if (found.size() < kMostElements) found.push_back(value);
  });
  return found;
}

std::size_t JsonSplice::count(const Value& list) const {
  std::size_t found = 0;
  each(list, [&](const Value&) { ++found; });
  return found;
}

void JsonSplice::replace(std::size_t begin, std::size_t end, std::string text) {
  changes_.push_back({begin, end, std::move(text)});
}

JsonSplice::Value JsonSplice::list_or_make(std::string_view key, const std::string& items) {
  const Value list = member(root(), key);
  if (!list) {
    const std::size_t close = root().end - 1;
    replace(close, close, ",\"" + std::string(key) + "\":[" + items + "]");
  }
  return list;
}

void JsonSplice::append(std::string_view key, const std::string& items) {
  const Value list = list_or_make(key, items);
  if (list) replace(list.end - 1, list.end - 1, (count(list) == 0 ? "" : ",") + items);
}

void JsonSplice::prepend(std::string_view key, const std::string& items) {
  const Value list = list_or_make(key, items);
  if (list) replace(list.begin + 1, list.begin + 1, items + (count(list) == 0 ? "" : ","));
}

void JsonSplice::assign(std::string_view key, const std::string& items) {
  const Value list = list_or_make(key, items);
  if (list) replace(list.begin, list.end, "[" + items + "]");
}

std::string JsonSplice::finish() const {
  std::vector<Change> changes = changes_;
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t at = 0;
  for (const Change& change : changes) {
    result += text_.substr(at, change.begin - at);
    result += change.text;
    at = change.end;
  }
  return result += text_.substr(at);
}

}  // namespace shigusa
