// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>

#include "table.hpp"

// Form of a shard's tables. A shard may be untrusted, and so is its checksum; readers of its tables
// rely on these checks alone.
namespace shigusa {

// Whether two columns have the same form, apart from rows and descriptions.
[[nodiscard]] bool same_column(const Column& a, const Column& b);

// Fails if a table, by its path, lacks a column or list of names that this program writes, or has
// one of another width, type or words.
[[nodiscard]] Result<void> check_form(const Table& empty);

// Fails if columns differ in their number of rows, or have values that this program does not write:
// infinities, numbers without a word, zero durations, malformed texts.
[[nodiscard]] Result<void> check_values(const Table& table);

// Largest number of goals of a task.
inline constexpr std::size_t kMostOfTask = 1000;

}  // namespace shigusa
