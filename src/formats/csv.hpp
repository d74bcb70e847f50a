// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// One column of a table, with its unit in the name: "right_knee.flexion [rad]".
struct CsvColumn {
  std::string name;
  std::vector<double> values;
};

// Text as one field, quoted if it holds a separator, a quote or a line break, or is empty, which
// would give an empty line.
[[nodiscard]] std::string csv_field(std::string_view text);

// Writes columns as CSV text (RFC 4180, but with LF line ends): a header row of the names, then one
// row per value. Names are quoted if necessary; numbers have a decimal point in every locale and
// the fewest digits that read back to the same double. Fails if there is no column, if columns
// differ in length, or at a value that is not finite.
[[nodiscard]] Result<std::string> format_csv(std::span<const CsvColumn> columns);

}  // namespace shigusa
