// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/request.hpp>
#include <string>

namespace shigusa::bench {

// Pairs of neighbouring goals of a grid that are reached by first choices.
struct Evenness {
  int pairs = 0;
  int uneven = 0;      // with a difference of the knees above 20° at the end
  double worst = 0.0;  // rad
};
// Number of the default preset's tasks affected by that change.
[[nodiscard]] Evenness evenness_of(const std::function<void(Task&)>& change);

// Counts how often neighbouring goals are reached in different styles.
[[nodiscard]] std::string evenness_section();

}  // namespace shigusa::bench
