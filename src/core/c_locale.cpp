// SPDX-License-Identifier: MIT
#include "c_locale.hpp"

namespace shigusa {

#ifdef _WIN32

WithinCLocale::WithinCLocale()
    : own_(_configthreadlocale(_ENABLE_PER_THREAD_LOCALE)), before_(setlocale(LC_ALL, nullptr)) {
  setlocale(LC_ALL, "C");
}

WithinCLocale::~WithinCLocale() {
  setlocale(LC_ALL, before_.c_str());
  _configthreadlocale(own_);
}

#else

namespace {

locale_t c_locale() {
  static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
  return locale;
}

}  // namespace

WithinCLocale::WithinCLocale() : before_(uselocale(c_locale())) {}
WithinCLocale::~WithinCLocale() { uselocale(before_); }

#endif

}  // namespace shigusa
