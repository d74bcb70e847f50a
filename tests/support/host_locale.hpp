// SPDX-License-Identifier: MIT
#pragma once

#include <locale.h>
#include <stdlib.h>

#include <locale>
#include <stdexcept>
#include <string>

#include "support/work_folder.hpp"

namespace shigusa::testing_support {

// Sets the locale of the whole process, as Qt and GTK programs do, during its lifetime. A missing
// locale is built, which needs Debian's package locales.
class HostLocale {
 public:
  // `language`: "de_DE" writes 1,5 and "ps_AF" 1٫5, with a decimal point of two bytes.
  explicit HostLocale(const std::string& language) {
    const std::string name = language + ".UTF-8";
    if (choose(name)) return;
    const std::string made = "localedef -i " + language + " -f UTF-8 '" +
                             (folder_.path() / name).string() + "' > /dev/null 2>&1";
    setenv("LOCPATH", folder_.path().c_str(), 1);
    chosen_ = system(made.c_str()) == 0 && choose(name);
  }
  HostLocale(const HostLocale&) = delete;
  HostLocale& operator=(const HostLocale&) = delete;
  ~HostLocale() {
    std::locale::global(std::locale::classic());
    unsetenv("LOCPATH");
  }

  // False where it is not there and cannot be made.
  [[nodiscard]] bool chosen() const { return chosen_; }

 private:
  // For C and for C++; names of locales are the C library's.
  bool choose(const std::string& name) {
    try {
      std::locale::global(std::locale(name));
      chosen_ = std::string(localeconv()->decimal_point) != ".";
    } catch (const std::runtime_error&) {
      chosen_ = false;
    }
    return chosen_;
  }

  WorkFolder folder_;
  bool chosen_ = false;
};

}  // namespace shigusa::testing_support
