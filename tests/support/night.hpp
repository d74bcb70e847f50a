// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace shigusa::testing_support {

// Number of cases of a slow property: all at night (scripts/nightly sets SHIGUSA_NIGHT), the first
// of them by day.
inline int cases(int at_night, int by_day) {
  return std::getenv("SHIGUSA_NIGHT") != nullptr ? at_night : by_day;
}

}  // namespace shigusa::testing_support
