// SPDX-License-Identifier: MIT
#pragma once

#include <cfenv>

namespace shigusa::door {

// Scope with the floating-point environment that all results assume: rounding to nearest, denormals
// kept, no traps. Restores the host's environment afterwards, including its flags.
class OwnArithmetic {
 public:
  OwnArithmetic() noexcept {
    (void)std::fegetenv(&host_);
    (void)std::fesetenv(FE_DFL_ENV);
  }
  ~OwnArithmetic() { (void)std::fesetenv(&host_); }
  OwnArithmetic(const OwnArithmetic&) = delete;
  OwnArithmetic& operator=(const OwnArithmetic&) = delete;

  [[nodiscard]] const std::fenv_t& host() const { return host_; }

 private:
  std::fenv_t host_{};
};

// Scope with the host's floating-point environment, for calls of the host's functions.
class HostArithmetic {
 public:
  explicit HostArithmetic(const std::fenv_t& host) noexcept { (void)std::fesetenv(&host); }
  ~HostArithmetic() { (void)std::fesetenv(FE_DFL_ENV); }
  HostArithmetic(const HostArithmetic&) = delete;
  HostArithmetic& operator=(const HostArithmetic&) = delete;
};

}  // namespace shigusa::door
