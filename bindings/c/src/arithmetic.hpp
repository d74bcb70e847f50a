// SPDX-License-Identifier: MIT
#pragma once

#include <cfenv>

namespace shigusa::door {

// The arithmetic that all results are of, while this lives: rounded to nearest, numbers near 0 as
// they are, nothing trapped. The host's own comes back after it, with the flags that it had.
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

// The host's arithmetic, while a function of its own runs.
class HostArithmetic {
 public:
  explicit HostArithmetic(const std::fenv_t& host) noexcept { (void)std::fesetenv(&host); }
  ~HostArithmetic() { (void)std::fesetenv(FE_DFL_ENV); }
  HostArithmetic(const HostArithmetic&) = delete;
  HostArithmetic& operator=(const HostArithmetic&) = delete;
};

}  // namespace shigusa::door
