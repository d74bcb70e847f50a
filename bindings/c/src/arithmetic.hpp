// SPDX-License-Identifier: MIT
#pragma once

#include <cfenv>

#ifdef _WIN32
#include <immintrin.h>
#endif

namespace shigusa::door {

// The floating-point environment of a thread, and the one that all results assume: rounding to
// nearest, denormals kept, no traps.
#ifdef _WIN32
// mingw's fesetenv(FE_DFL_ENV) leaves the one of SSE, in which all is computed
struct Arithmetic {
  unsigned control = 0x1F80;

  static Arithmetic now() noexcept { return {_mm_getcsr()}; }
  void set() const noexcept { _mm_setcsr(control); }
  static void set_own() noexcept { Arithmetic{}.set(); }
};
#else
struct Arithmetic {
  std::fenv_t environment{};

  static Arithmetic now() noexcept {
    Arithmetic here;
    (void)std::fegetenv(&here.environment);
    return here;
  }
  void set() const noexcept { (void)std::fesetenv(&environment); }
  static void set_own() noexcept { (void)std::fesetenv(FE_DFL_ENV); }
};
#endif

// Scope with the environment of results. Restores the host's afterwards, including its flags.
class OwnArithmetic {
 public:
  OwnArithmetic() noexcept : host_(Arithmetic::now()) { Arithmetic::set_own(); }
  ~OwnArithmetic() { host_.set(); }
  OwnArithmetic(const OwnArithmetic&) = delete;
  OwnArithmetic& operator=(const OwnArithmetic&) = delete;

  [[nodiscard]] const Arithmetic& host() const { return host_; }

 private:
  Arithmetic host_;
};

// Scope with the host's environment, for calls of the host's functions.
class HostArithmetic {
 public:
  explicit HostArithmetic(const Arithmetic& host) noexcept { host.set(); }
  ~HostArithmetic() { Arithmetic::set_own(); }
  HostArithmetic(const HostArithmetic&) = delete;
  HostArithmetic& operator=(const HostArithmetic&) = delete;
};

}  // namespace shigusa::door
