// SPDX-License-Identifier: MIT
#pragma once

#include <locale.h>

namespace shigusa {

// The C library's own locale, in which numbers have a decimal point.
[[nodiscard]] locale_t c_locale();

// Sets the C locale for the current thread during its lifetime, so that the C library reads and
// writes numbers with a decimal point, whatever the program's locale. For libraries that read
// numbers by strtod.
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
