// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// A text as JSON writes it, with its quotes, and a list of finite numbers that read back exactly.
[[nodiscard]] std::string json_quoted(const std::string& text);
[[nodiscard]] std::string json_numbers(std::initializer_list<double> values);

// Changes places of a JSON text and leaves every other byte as it is. The text must have been
// parsed before, so nothing is checked but that no place lies beyond it.
class JsonSplice {
 public:
  explicit JsonSplice(std::string_view text);

  // A value of the text.
  struct Value {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t key_begin = 0;  // of an object's member: where its key begins
    explicit operator bool() const { return end > begin; }
  };

  [[nodiscard]] Value root() const;
  [[nodiscard]] std::string_view text_of(const Value& value) const;
  // Of an object the member of that name, the last where it comes twice; else nothing.
  [[nodiscard]] Value member(const Value& object, std::string_view key) const;
  // Of a list its elements, kMostElements at most, or how many there are; of anything else none.
  static constexpr std::size_t kMostElements = 65'536;
  [[nodiscard]] std::vector<Value> elements(const Value& list) const;
  [[nodiscard]] std::size_t count(const Value& list) const;

  void replace(std::size_t begin, std::size_t end, std::string text);
  // Adds to the list that is the root's member of that name, and makes it where there is none.
  // `items`: elements, with commas between them.
  void append(std::string_view key, const std::string& items);
  void prepend(std::string_view key, const std::string& items);
  // Puts them in the place of that list's.
  void assign(std::string_view key, const std::string& items);

  // The text with all changes, which must not overlap.
  [[nodiscard]] std::string finish() const;

 private:
  [[nodiscard]] std::size_t skip_blanks(std::size_t at) const;
  // Behind the colon or comma that comes next.
  [[nodiscard]] std::size_t after_mark(std::size_t at) const;
  [[nodiscard]] std::size_t end_of_value(std::size_t at) const;
  // Where the list of that name is; makes it of the items where there is none.
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
