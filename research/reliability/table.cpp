// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <charconv>
#include <utility>

namespace shigusa::bench {
namespace {

// Splits off the text before the next separator.
std::string_view next_field(std::string_view& rest, char separator) {
  const std::size_t end = rest.find(separator);
  const std::string_view field = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  return field;
}

}  // namespace

Table::Table(std::string_view csv) {
  std::string_view header = next_field(csv, '\n');
  std::vector<std::string> names;
  while (!header.empty()) names.emplace_back(next_field(header, ','));
  std::vector<std::vector<double>> values(names.size());
  while (!csv.empty()) {
    std::string_view line = next_field(csv, '\n');
    for (std::vector<double>& column : values) {
      const std::string_view field = next_field(line, ',');
      double value = 0.0;
      std::from_chars(field.data(), field.data() + field.size(), value);
      column.push_back(value);
    }
    ++rows_;
  }
  for (std::size_t k = 0; k < names.size(); ++k) columns_[names[k]] = std::move(values[k]);
}

}  // namespace shigusa::bench
