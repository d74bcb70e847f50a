// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>

#include "table.hpp"

// The form of a shard's tables. A shard may be a stranger's, and its sum a stranger's too: whoever
// reads its tables relies on these alone.
namespace shigusa {

// Whether two columns are of one form, whatever their rows and what they say.
[[nodiscard]] bool same_column(const Column& a, const Column& b);

// Fails where a table, by its path, is without a column or a list of names that this program
// writes, or has it in another form: of another width, another type, other words.
[[nodiscard]] Result<void> check_form(const Table& empty);

// Fails where columns have unlike rows, or numbers and texts that this program does not write:
// infinities, numbers without a word, durations of no time, texts that are no text.
[[nodiscard]] Result<void> check_values(const Table& table);

// Goals of one task at most, and motions and obstacles.
inline constexpr std::size_t kMostOfTask = 1000;

}  // namespace shigusa
