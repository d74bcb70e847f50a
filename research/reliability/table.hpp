// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa::bench {

// An exported CSV, read independently of the library: columns by their names.
class Table {
 public:
  Table() = default;
  // Names must not contain commas or quotes.
  explicit Table(std::string_view csv);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] bool has(const std::string& name) const { return columns_.count(name) != 0; }
  [[nodiscard]] double at(const std::string& name, std::size_t row) const {
    return columns_.at(name).at(row);
  }
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const {
    return columns_.at(name);
  }
  [[nodiscard]] std::vector<double>& column(const std::string& name) { return columns_.at(name); }

 private:
  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

}  // namespace shigusa::bench
