// SPDX-License-Identifier: MIT
#include "formats/csv.hpp"

#include <fmt/format.h>

#include <iterator>
#include <shigusa/math.hpp>
#include <string_view>

namespace shigusa {
namespace {

Result<void> check(std::span<const CsvColumn> columns) {
  if (columns.empty()) return fail(ErrorCode::invalid_argument, "a table needs a column");
  const CsvColumn& first = columns.front();
  for (const CsvColumn& column : columns) {
    if (column.values.size() != first.values.size()) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("{} values, but column '{}' has {}", column.values.size(), first.name,
                              first.values.size()),
                  fmt::format("column '{}'", column.name));
    }
    for (std::size_t row = 0; row < column.values.size(); ++row) {
      if (!is_finite(column.values[row])) {
        return fail(ErrorCode::invalid_argument,
                    fmt::format("value {} is {}; only finite numbers can be written", row + 1,
                                column.values[row]),
                    fmt::format("column '{}'", column.name));
      }
    }
  }
  return {};
}

}  // namespace

std::string csv_field(std::string_view text) {
  if (!text.empty() && text.find_first_of(",\"\r\n") == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

Result<std::string> format_csv(std::span<const CsvColumn> columns) {
  SHG_TRY(check(columns));
  std::string text;
  for (const CsvColumn& column : columns) {
    if (!text.empty()) text += ',';
    text += csv_field(column.name);
  }
  text += '\n';
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    for (const CsvColumn& column : columns) {
      if (&column != &columns.front()) text += ',';
      fmt::format_to(std::back_inserter(text), "{}", column.values[row]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace shigusa
