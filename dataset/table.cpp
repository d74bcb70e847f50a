// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <algorithm>

#include "core/check.hpp"

namespace shigusa {

void Column::push(std::string_view text) {
  std::size_t size = std::min(text.size(), text_size);
  const auto goes_on = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  while (size > 0 && size < text.size() && goes_on(text[size])) --size;
  bytes.append(text.substr(0, size));
  bytes.append(text_size - size, '\0');
}

std::vector<std::string> Column::texts() const {
  std::vector<std::string> all;
  for (std::size_t at = 0; at + text_size <= bytes.size(); at += text_size) {
    const std::string_view padded(bytes.data() + at, text_size);
    all.emplace_back(padded.substr(0, padded.find('\0')));
  }
  return all;
}

Column& Table::operator[](std::string_view name) {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [name](const Column& column) { return column.name == name; });
  SHG_CHECK(found != columns.end(), "a table's column must be there");
  return *found;
}

const Column* Table::find(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [name](const Column& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

const std::vector<std::string>* Table::names_of(std::string_view what) const {
  for (const auto& [name, list] : names) {
    if (name == what) return &list;
  }
  return nullptr;
}

void append(std::vector<Table>&& more, std::vector<Table>& tables) {
  for (Table& table : more) {
    const auto same = std::find_if(tables.begin(), tables.end(), [&table](const Table& known) {
      return known.path == table.path;
    });
    if (same == tables.end()) {
      tables.push_back(std::move(table));
      continue;
    }
    SHG_CHECK(same->columns.size() == table.columns.size(), "tables of one path have like columns");
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      same->columns[k].bytes += table.columns[k].bytes;
    }
  }
}

}  // namespace shigusa
