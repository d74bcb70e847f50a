// SPDX-License-Identifier: MIT
#include "shard_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <shigusa/math.hpp>

#include "core/text.hpp"
#include "data_rows.hpp"
#include "motion_columns.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

// Range of a column; other columns accept any finite number, or NaN.
struct Allowed {
  std::string_view column;
  double low;
  double high;
  bool none;  // NaN too
};
constexpr double kMostSeconds = 1e4;
constexpr double kMostSize = 1e6;     // m, kg: robots may be giants
constexpr double kMostPlace = 1e6;    // m
constexpr double kMostNumber = 1e30;  // of any other unit
constexpr std::array kAllowed{
    Allowed{"duration_s", 1e-3, kMostSeconds, false},
    Allowed{"stature_m", 1e-6, kMostSize, false},
    Allowed{"mass_kg", 1e-9, kMostSize, false},
    Allowed{"rank", 1.0, 255.0, false},
    Allowed{"score", -kMostNumber, kMostNumber, false},
};

Allowed allowed_of(const Column& column) {
  const auto row = std::find_if(kAllowed.begin(), kAllowed.end(), [&column](const Allowed& one) {
    return one.column == column.name;
  });
  if (row != kAllowed.end()) return *row;
  if (column.unit == "m") return {column.name, -kMostPlace, kMostPlace, true};
  return {column.name, -kMostNumber, kMostNumber, true};
}

bool is_fraction(const Column& column) {
  return column.type == ElementType::f32 || column.type == ElementType::f64;
}

// Whether a text is UTF-8 without control characters.
bool is_text(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = utf8_length(text);
    const auto first = static_cast<unsigned char>(text.front());
    if (size == 0 || first < 0x20 || first == 0x7F) return false;
    text.remove_prefix(size);
  }
  return true;
}

bool are_texts(const std::vector<std::string>& texts) {
  return std::all_of(texts.begin(), texts.end(), is_text);
}

// Error in a column's numbers; empty if there is none. `refused`: rows of refused tasks, which have
// no values.
std::string wrong_numbers(const Column& column, const std::vector<bool>& refused) {
  Allowed allowed = allowed_of(column);
  const std::size_t parts = column.rows() == 0 ? 1 : column.row_size() / size_of(column.type);
  for (std::size_t row = 0; row < column.rows(); ++row) {
    const bool none = allowed.none || (row < refused.size() && refused[row]);
    for (std::size_t k = 0; k < parts; ++k) {
      const double number = number_in(column, row, k);
      if (!column.words.empty()) {
        if (number < static_cast<double>(column.words.size())) continue;
        return fmt::format("is {} in row {}, and has {} words", number, row, column.words.size());
      }
      if ((number >= allowed.low && number <= allowed.high) || (none && number != number)) continue;
      if (!is_fraction(column) && allowed.low < 0.0) continue;
      return fmt::format("is {} in row {}; allowed is {} to {}", number, row, allowed.low,
                         allowed.high);
    }
  }
  return {};
}

// Checks that rotations of nodes are unit quaternions.
bool has_turns(const Column& column) {
  constexpr double kOff = 0.1;
  for (std::size_t row = 0; row < column.rows(); ++row) {
    for (std::size_t k = 0; k * sizeof(float) < column.row_size(); k += 4) {
      double square = 0.0;
      for (std::size_t part = k; part < k + 4; ++part) {
        square += number_in(column, row, part) * number_in(column, row, part);
      }
      if (!(square > 1.0 - kOff && square < 1.0 + kOff)) return false;
    }
  }
  return true;
}

// Refused tasks in a table of tasks.
std::vector<bool> refused_rows(const Table& table) {
  std::vector<bool> refused;
  const Column* const status = table.find("status");
  if (table.path != kTasksTable || status == nullptr) return refused;
  for (std::size_t row = 0; row < status->rows(); ++row) {
    refused.push_back(Row{&table, row}.text("status") == kRefused);
  }
  return refused;
}

std::string wrong_values(const Column& column, const std::vector<bool>& refused) {
  if (column.type == ElementType::text) return are_texts(column.texts()) ? "" : "has no text";
  std::string wrong = wrong_numbers(column, refused);
  if (wrong.empty() && column.name == word_of(DatasetSeries::nodes) && !has_turns(column)) {
    wrong = "has turns that are none";
  }
  return wrong;
}

// Required columns of a motion table, including those of its series.
Result<Table> motion_form(const Table& table) {
  Table form{.path = table.path, .names = table.names};
  for (const char* list : kMotionLists) {
    const std::vector<std::string>* const names = table.names_of(list);
    if (names == nullptr) return fail(ErrorCode::parse, fmt::format("has no list `{}`", list), "");
    if (!are_texts(*names)) return fail(ErrorCode::parse, "has names that are no text", list);
  }
  for (const char* list : kWorkLists) {
    const std::vector<std::string>* const names = table.names_of(list);
    if (names != nullptr && !are_texts(*names)) {
      return fail(ErrorCode::parse, "has names that are no text", list);
    }
  }
  std::vector<DatasetSeries> series;
  for (const auto& [one, word] : kEnumWords<DatasetSeries>) {
    if (table.find(word) != nullptr) series.push_back(one);
  }
  add_motion_columns(series, form);
  return form;
}

// Whether each node's parent precedes it.
Result<void> check_nodes(const Table& table) {
  const std::vector<std::string>& names = *table.names_of("nodes");
  const std::vector<std::string>& parents = *table.names_of("node_parents");
  bool good = !names.empty() && names.size() == parents.size();
  for (std::size_t n = 0; good && n < names.size(); ++n) {
    const auto end = names.begin() + static_cast<std::ptrdiff_t>(n);
    good = parents[n].empty() || std::find(names.begin(), end, parents[n]) != end;
  }
  if (good) return {};
  return fail(ErrorCode::parse, "has nodes whose parents are none before them", "node_parents");
}

}  // namespace

bool same_column(const Column& a, const Column& b) {
  return a.name == b.name && a.type == b.type && a.shape == b.shape && a.text_size == b.text_size &&
         a.words == b.words;
}

Result<void> check_form(const Table& empty) {
  Table form{.path = empty.path};
  for (const Table& known : empty_tables()) {
    if (known.path == empty.path) form = known;
  }
  if (form.columns.empty()) {
    SHG_TRY_ASSIGN(form, motion_form(empty));
    SHG_TRY(check_nodes(empty));
  }
  for (const Column& column : form.columns) {
    const Column* const own = empty.find(column.name);
    if (own == nullptr) return fail(ErrorCode::parse, "is not there", column.name);
    if (!same_column(*own, column)) {
      return fail(ErrorCode::parse, "has another form than this program writes", column.name);
    }
  }
  return {};
}

Result<void> check_values(const Table& table) {
  const std::vector<bool> refused = refused_rows(table);
  for (const Column& column : table.columns) {
    const std::string wrong = wrong_values(column, refused);
    if (!wrong.empty()) return fail(ErrorCode::parse, wrong, column.name);
  }
  return {};
}

}  // namespace shigusa
