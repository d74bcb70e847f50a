// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

#include "formats/json_text.hpp"

namespace shigusa {

inline constexpr double kMillimetres = 1000.0;  // per metre

// Adds the measures that summary.json and the object of `shigusa score --json` have alike:
// `most_loaded`, `over_limit`, `support` (of a body that stands), `collision` (where there is one)
// and `final_posture`.
void add_measures(const BodyModel& body, const MotionMeasures& measures, const FinalPosture& ends,
                  Json& json);

// The penalties of a score by the names of their criteria.
[[nodiscard]] Json penalties_to_json(const Score& score);

// Why a candidate is not possible: numbers of each kind, and the sentence that says them.
[[nodiscard]] Json reasons_to_json(const Judgement& judgement);

}  // namespace shigusa
