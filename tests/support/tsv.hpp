// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

// Tables of facts: lines of tab-separated cells below a line of their names; # begins a comment.
namespace shigusa::testing_support {

class TsvRow {
 public:
  explicit TsvRow(std::map<std::string, std::string> cells) : cells_(std::move(cells)) {}

  // The cell of a name; throws std::out_of_range without one.
  [[nodiscard]] const std::string& text(const std::string& name) const { return cells_.at(name); }
  [[nodiscard]] double number(const std::string& name) const { return std::stod(text(name)); }
  [[nodiscard]] int whole(const std::string& name) const { return std::stoi(text(name)); }
  [[nodiscard]] bool has(const std::string& name) const {
    return text(name) != "-" && text(name) != "undefined";
  }

 private:
  std::map<std::string, std::string> cells_;
};

// The rows of a file of shared/ergonomics; none where it is absent.
inline std::vector<TsvRow> ergonomics_rows(const std::string& file) {
  std::ifstream in(std::filesystem::path(SHIGUSA_SHARED_DIR) / "ergonomics" / file);
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == '\t')
        cells.emplace_back();
      else
        cells.back() += c;
    }
    return cells;
  };
  std::vector<std::string> names;
  std::vector<TsvRow> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> cells = cells_of(line);
    if (names.empty()) {
      names = cells;
      continue;
    }
    std::map<std::string, std::string> row;
    for (std::size_t k = 0; k < cells.size() && k < names.size(); ++k) row[names[k]] = cells[k];
    rows.emplace_back(std::move(row));
  }
  return rows;
}

}  // namespace shigusa::testing_support
