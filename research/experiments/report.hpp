// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

// Formatting of texts and numbers for docs/experiments.md.
namespace shigusa::bench {

// Quantile q (0..1) of sorted values, the nearest one; values must not be empty.
[[nodiscard]] double quantile(std::vector<double> values, double q);
[[nodiscard]] double median(const std::vector<double>& values);

// Median and quartiles: "0.512 (0.433–0.610)".
[[nodiscard]] std::string spread(const std::vector<double>& values);

// Percentage of `count` in `all`: "12.3 %", with that number of decimals unless it is 0 or 100.
[[nodiscard]] std::string percent(double count, double all, int digits = 1);

// A Markdown table, row by row.
class Table {
 public:
  explicit Table(const std::vector<std::string>& head);
  void add(const std::vector<std::string>& cells);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// CPU time (ms) of the current thread since construction, which is hardly affected by other load.
class Stopwatch {
 public:
  [[nodiscard]] double milliseconds() const { return now() - begin_; }

 private:
  static double now();

  double begin_ = now();
};

}  // namespace shigusa::bench
