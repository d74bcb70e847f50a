// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

// Words and numbers of docs/experiments.md.
namespace shigusa::bench {

// The value at the share q (0..1) of the sorted values, the nearest one; values not empty.
[[nodiscard]] double quantile(std::vector<double> values, double q);
[[nodiscard]] double median(const std::vector<double>& values);

// "0.512 (0.433–0.610)": median and quartiles.
[[nodiscard]] std::string spread(const std::vector<double>& values);

// "12.3 %" of `count` in `all`, with that number of digits after the point unless it is 0 or 100.
[[nodiscard]] std::string percent(double count, double all, int digits = 1);

// A table of Markdown, row by row.
class Table {
 public:
  explicit Table(const std::vector<std::string>& head);
  void add(const std::vector<std::string>& cells);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// Milliseconds of the processor that its thread has had since it was made: what else the machine
// does counts little.
class Stopwatch {
 public:
  [[nodiscard]] double milliseconds() const { return now() - begin_; }

 private:
  static double now();

  double begin_ = now();
};

}  // namespace shigusa::bench
