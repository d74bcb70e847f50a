// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa::app {

// Width of tables in characters.
inline constexpr std::size_t kTableWidth = 100;

// Wraps a text to kTableWidth at blanks, but not between a number and its unit; continuation lines
// are indented. Ends with a line feed.
[[nodiscard]] std::string hanging(std::string_view text);
// Wraps words that are kept whole and may contain blanks.
[[nodiscard]] std::string hanging(const std::vector<std::string>& words);

// A text table. Columns that are 0 in all rows are left out and listed separately; if the others
// are too wide, the table continues below with the first column repeated.
class TextTable {
 public:
  enum class Align { left, right };

  // Adds a column of one text per row; long texts are cut.
  void add(std::string head, Align align, std::vector<std::string> texts);
  // Adds a column of numbers; it is left out if all of them print as 0.
  void add_numbers(std::string head, const std::vector<double>& values, int digits);

  // Adds a column in which "-" means nothing; it is left out if it has nothing else.
  void add_known(std::string head, Align align, std::vector<std::string> texts);

  // Heads of the columns that were left out.
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
