// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/layers/layer.hpp>
#include <shigusa/layers/limb_library.hpp>

namespace shigusa {

// Searches that one arm which passes through the body takes at most (rule R11); after the last one
// the collision is left.
inline constexpr int kCollisionRounds = 3;

// What layered presets are asked beside what every task says.
struct LayeredSettings {
  // How the arms' layers are searched; threads and SIMD set are the task's.
  LimbSearch limb_search = LimbSearch::ladder;
  // Where the arms' libraries are kept; without it they are searched anew, with the same result.
  LimbStore store{};
  int feedback_rounds = kCollisionRounds;  // 0: none
};

}  // namespace shigusa
