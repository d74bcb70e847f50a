// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/request.hpp>
#include <string>

namespace shigusa::bench {

// Pairs of neighbours of a grid of goals that are reached by first choices.
struct Evenness {
  int pairs = 0;
  int uneven = 0;      // with a difference of the knees above 20° at the end
  double worst = 0.0;  // rad
};
// Of the default preset's tasks after that change.
[[nodiscard]] Evenness evenness_of(const std::function<void(Task&)>& change);

// How often goals beside one another are reached in different styles.
[[nodiscard]] std::string evenness_section();

}  // namespace shigusa::bench
