// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa::app {

// The width that tables keep to, in characters.
inline constexpr std::size_t kTableWidth = 100;

// The text in lines of at most kTableWidth, broken at blanks, but not between a number
// and its unit; those after the first are indented. Ends with the end of a line.
[[nodiscard]] std::string hanging(std::string_view text);
// The same of words that hold together, with blanks of their own.
[[nodiscard]] std::string hanging(const std::vector<std::string>& words);

// A table for a person. Columns that are 0 in all rows are left out, and told beside; where the
// others are too wide together, the table goes on below with the first column again.
class TextTable {
 public:
  enum class Align { left, right };

  // Adds a column; its texts are one for each row. A text that is too long is cut.
  void add(std::string head, Align align, std::vector<std::string> texts);
  // Adds a column of numbers; where all of them print as 0, it is left out.
  void add_numbers(std::string head, const std::vector<double>& values, int digits);

  // Adds a column in which "-" is nothing; where it has nothing else, it is left out.
  void add_known(std::string head, Align align, std::vector<std::string> texts);

  // The heads of the columns that were left out.
  [[nodiscard]] const std::vector<std::string>& zeros() const { return zeros_; }
  [[nodiscard]] std::string text() const;

 private:
  struct Column {
    std::string head;
    Align align = Align::right;
    std::vector<std::string> texts;
    std::size_t width = 0;
  };
  [[nodiscard]] std::string block(std::size_t first, std::size_t last) const;

  std::vector<Column> columns_;
  std::vector<std::string> zeros_;
};

}  // namespace shigusa::app
