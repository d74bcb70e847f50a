// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/run.hpp>

#include "support/tsv.hpp"

// Rows of a file of shared/ergonomics; skips the test where the folder is absent, and fails for a
// file without rows.
#define SHG_ROWS(rows, file, least)                                                   \
  const std::vector<TsvRow> rows = ::shigusa::testing_support::ergonomics_rows(file); \
  if (rows.empty()) GTEST_SKIP() << "no shared/ergonomics/" << (file);                \
  ASSERT_GE(rows.size(), std::size_t{least})

namespace shigusa::testing_support {

// Drawn cases of a property of the formulas.
inline constexpr int kFormulaCases = 10'000;

// A drawn whole number.
inline int drawn(Random& random, int least, int most) {
  return least + static_cast<int>(random.below(static_cast<std::uint32_t>(most - least + 1)));
}

}  // namespace shigusa::testing_support
