// SPDX-License-Identifier: MIT
#include "text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "manual.hpp"

namespace shigusa::app {
namespace {

constexpr std::size_t kCellMost = 60;
constexpr std::string_view kGap = "  ";

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

// Text of a cell, cut with an ellipsis if it is too long.
std::string cut(std::string text) {
  if (width_of(text) <= kCellMost) return text;
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size(); ++end) {
    if (!continues(text[end]) && ++count > kCellMost - 1) break;
  }
  return text.substr(0, end) + "…";
}

// Whether a word after a number may be its unit: "N·m", "kg,".
bool is_unit(std::string_view word, const std::string& before) {
  constexpr std::size_t kLongest = 4;
  return !before.empty() && before.back() >= '0' && before.back() <= '9' &&
         width_of(word) <= kLongest;
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string room(width - std::min(width, width_of(text)), ' ');
  return left ? text + room : room + text;
}

}  // namespace

std::string hanging(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, blank);
    if (!words.empty() && is_unit(word, words.back())) {
      words.back() += " " + std::string(word);
    } else {
      words.emplace_back(word);
    }
    text.remove_prefix(std::min(blank + 1, text.size()));
  }
  return hanging(words);
}

std::string hanging(const std::vector<std::string>& words) {
  std::string lines;
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty() && width_of(line) + 1 + width_of(word) > kTableWidth) {
      lines += line + "\n";
      line = std::string(kGap) + word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
  }
  return lines + line + "\n";
}

void TextTable::add(std::string head, Align align, std::vector<std::string> texts) {
  Column column{std::move(head), align, std::move(texts), 0};
  column.width = width_of(column.head);
  for (std::string& text : column.texts) {
    text = cut(std::move(text));
    column.width = std::max(column.width, width_of(text));
  }
  columns_.push_back(std::move(column));
}

void TextTable::add_numbers(std::string head, const std::vector<double>& values, int digits) {
  std::vector<std::string> texts;
  bool zero = true;
  for (const double value : values) {
    texts.push_back(fmt::format("{:.{}f}", value, digits));
    zero = zero && texts.back().find_first_not_of("-0.") == std::string::npos;
  }
  if (zero) {
    zeros_.push_back(std::move(head));
  } else {
    add(std::move(head), Align::right, std::move(texts));
  }
}

void TextTable::add_known(std::string head, Align align, std::vector<std::string> texts) {
  const bool none =
      std::all_of(texts.begin(), texts.end(), [](const std::string& text) { return text == "-"; });
  if (none) {
    zeros_.push_back(std::move(head));
  } else {
    add(std::move(head), align, std::move(texts));
  }
}

// The first column and those from `first` to before `last`.
std::string TextTable::block(std::size_t first, std::size_t last) const {
  std::string text;
  const std::size_t rows = columns_.front().texts.size();
  for (std::size_t row = 0; row <= rows; ++row) {
    std::string line;
    for (std::size_t k = 0; k < last; k = k == 0 ? std::max<std::size_t>(first, 1) : k + 1) {
      const Column& column = columns_[k];
      const std::string& cell = row == 0 ? column.head : column.texts[row - 1];
      line += (k == 0 ? "" : kGap);
      line += padded(cell, column.width, column.align == Align::left);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string TextTable::text() const {
  std::string text;
  for (std::size_t first = 1; first == 1 || first < columns_.size();) {
    std::size_t width = columns_.front().width;
    std::size_t last = first;
    while (last < columns_.size() &&
           (last == first || width + kGap.size() + columns_[last].width <= kTableWidth)) {
      width += kGap.size() + columns_[last++].width;
    }
    text += (text.empty() ? "" : "\n") + block(first, last);
    first = std::max(last, first + 1);
  }
  return text;
}

}  // namespace shigusa::app
