// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// JSON notation of a text, quoted, and of a list of finite numbers that read back exactly.
[[nodiscard]] std::string json_quoted(const std::string& text);
[[nodiscard]] std::string json_numbers(std::initializer_list<double> values);

// Edits parts of a JSON text and keeps every other byte. The text must have been parsed before;
// only ranges are checked.
class JsonSplice {
 public:
  explicit JsonSplice(std::string_view text);

  // A value within the text.
  struct Value {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t key_begin = 0;  // for an object's member: where its key begins
    explicit operator bool() const { return end > begin; }
  };

  [[nodiscard]] Value root() const;
  [[nodiscard]] std::string_view text_of(const Value& value) const;
  // Member of an object by name, the last one if repeated; empty if absent.
  [[nodiscard]] Value member(const Value& object, std::string_view key) const;
  // Elements of a list, at most kMostElements, or their number; empty for other values.
  static constexpr std::size_t kMostElements = 65'536;
  [[nodiscard]] std::vector<Value> elements(const Value& list) const;
  [[nodiscard]] std::size_t count(const Value& list) const;

  void replace(std::size_t begin, std::size_t end, std::string text);
  // Appends to the list that is the root's member of that name, creating it if absent. `items`:
  // elements separated by commas.
  void append(std::string_view key, const std::string& items);
  void prepend(std::string_view key, const std::string& items);
  // Replaces the contents of that list.
  void assign(std::string_view key, const std::string& items);

  // The text with all changes, which must not overlap.
  [[nodiscard]] std::string finish() const;

 private:
  [[nodiscard]] std::size_t skip_blanks(std::size_t at) const;
  // Position behind the next colon or comma.
  [[nodiscard]] std::size_t after_mark(std::size_t at) const;
  [[nodiscard]] std::size_t end_of_value(std::size_t at) const;
  // The list of that name; creates it with the items if absent.
  Value list_or_make(std::string_view key, const std::string& items);
  template <class Action>
  void each(const Value& list, Action&& action) const;

  struct Change {
    std::size_t begin;
    std::size_t end;
    std::string text;
  };
  std::string_view text_;
  std::vector<Change> changes_;
};

}  // namespace shigusa
