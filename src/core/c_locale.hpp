// SPDX-License-Identifier: MIT
#pragma once

#include <locale.h>

#include <string>

namespace shigusa {

// Sets the C library's own locale for the current thread during its lifetime, so that the C library
// reads and writes numbers with a decimal point, whatever the program's locale. For strtod, and
// libraries that call it.
class WithinCLocale {
 public:
  WithinCLocale();
  ~WithinCLocale();
  WithinCLocale(const WithinCLocale&) = delete;
  WithinCLocale& operator=(const WithinCLocale&) = delete;

 private:
#ifdef _WIN32
  int own_;  // whether the thread had a locale of its own
  std::string before_;
#else
  locale_t before_;
#endif
};

}  // namespace shigusa
