// SPDX-License-Identifier: MIT
#pragma once

#include <locale.h>

namespace shigusa {

// The C library's own locale, in which numbers have a point.
[[nodiscard]] locale_t c_locale();

// While one lives, the C library's functions that its thread calls read and write numbers with a
// point, whatever locale the program has chosen. For libraries that read numbers by strtod.
class WithinCLocale {
 public:
  WithinCLocale() : before_(uselocale(c_locale())) {}
  WithinCLocale(const WithinCLocale&) = delete;
  WithinCLocale& operator=(const WithinCLocale&) = delete;
  ~WithinCLocale() { uselocale(before_); }

 private:
  locale_t before_;
};

}  // namespace shigusa
