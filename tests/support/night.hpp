// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace shigusa::testing_support {

// How many cases of a slow property are tried: all where there is time for it (scripts/nightly sets
// SHIGUSA_NIGHT), the first of them by day.
inline int cases(int at_night, int by_day) {
  return std::getenv("SHIGUSA_NIGHT") != nullptr ? at_night : by_day;
}

}  // namespace shigusa::testing_support
