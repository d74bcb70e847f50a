// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <shigusa/error.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/parse_number.hpp"

namespace shigusa::bench {

// The parts of a text between each `at`; one at least.
inline std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

// Reads the cells of a row by the names of their columns.
class TabRow {
 public:
  TabRow(const std::vector<std::string_view>& head, std::vector<std::string_view> cells)
      : head_(&head), cells_(std::move(cells)) {}

  [[nodiscard]] std::string_view text(std::string_view column) const {
    const auto found = std::find(head_->begin(), head_->end(), column);
    const auto at = static_cast<std::size_t>(found - head_->begin());
    return at < cells_.size() ? cells_[at] : std::string_view{};
  }
  // NaN if absent
  [[nodiscard]] double number(std::string_view column) const {
    return parse_number(text(column)).value_or(std::nan(""));
  }

 private:
  const std::vector<std::string_view>* head_;
  std::vector<std::string_view> cells_;
};

// Fails if a table's head lacks a column.
inline Result<void> expect_columns(const std::vector<std::string_view>& head,
                                   std::initializer_list<const char*> columns,
                                   const std::filesystem::path& table) {
  for (const char* column : columns) {
    if (std::find(head.begin(), head.end(), column) != head.end()) continue;
    return fail(ErrorCode::parse, std::string("has no column ") + column, table.string());
  }
  return {};
}

}  // namespace shigusa::bench
