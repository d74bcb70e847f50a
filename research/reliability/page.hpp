// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "audit.hpp"
#include "cast.hpp"

namespace shigusa::bench {

// Page docs/reliability.md of these findings, by kind.
[[nodiscard]] std::string reliability_page(const std::vector<Audit>& kinds, const Cast& cast,
                                           int evaluations);

// Seconds and shares of each kind, for the terminal.
[[nodiscard]] std::string kinds_log(const std::vector<Audit>& kinds);

}  // namespace shigusa::bench
