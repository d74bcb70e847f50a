// SPDX-License-Identifier: MIT
#pragma once

#include "generate/parameter_space.hpp"
#include "record.hpp"

namespace shigusa::bench {

// Selection of the preset flat's parameters that are fitted to a record.
struct FitKind {
  const char* name;
  GeneCode code = GeneCode::natural;
  bool straight = false;  // without bow and sway
};
[[nodiscard]] std::vector<FitKind> fit_kinds();

struct FittedReach {
  int parameters = 0;  // how many
  Clip clip;           // empty if no parameters meet the goal
};

// The motion whose parameters fit the record best: the score is the rms over time of the
// differences in the degrees of freedom that goal and feet move, in place of the criteria. It is
// fitted to the data that it is compared with.
[[nodiscard]] FittedReach fitted_reach(const Recorded& reach, const FitKind& kind, int evaluations);

}  // namespace shigusa::bench
