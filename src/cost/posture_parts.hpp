// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/ergonomics.hpp>
#include <string_view>

namespace shigusa {

// A sub-score with its word in files and its range.
template <class Parts>
struct SubScore {
  std::string_view word;
  int Parts::*part;
  int least;
  int most;
};
inline constexpr std::array<SubScore<RebaParts>, 9> kRebaParts{{
    {"neck", &RebaParts::neck, 1, 4},
    {"trunk", &RebaParts::trunk, 1, 5},
    {"legs", &RebaParts::legs, 1, 4},
    {"load", &RebaParts::load, 0, 3},
    {"upper_arm", &RebaParts::upper_arm, 1, 6},
    {"lower_arm", &RebaParts::lower_arm, 1, 2},
    {"wrist", &RebaParts::wrist, 1, 3},
    {"coupling", &RebaParts::coupling, 0, 3},
    {"activity", &RebaParts::activity, 0, 3},
}};
inline constexpr std::array<SubScore<RulaParts>, 9> kRulaParts{{
    {"upper_arm", &RulaParts::upper_arm, 1, 6},
    {"lower_arm", &RulaParts::lower_arm, 1, 3},
    {"wrist", &RulaParts::wrist, 1, 4},
    {"wrist_twist", &RulaParts::wrist_twist, 1, 2},
    {"muscle", &RulaParts::muscle, 0, 1},
    {"force", &RulaParts::force, 0, 3},
    {"neck", &RulaParts::neck, 1, 6},
    {"trunk", &RulaParts::trunk, 1, 6},
    {"legs", &RulaParts::legs, 1, 2},
}};

}  // namespace shigusa
