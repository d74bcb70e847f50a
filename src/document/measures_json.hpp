// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/verdict.hpp>

#include "io/json_text.hpp"

namespace shigusa {

// What is told of generated and of recorded motions alike, as summary.json and the object of
// `shigusa score --json` have it: `most_loaded`, `over_limit`, `support` (of
// a body that stands), `collision` (where there is one) and `final_posture`.
void add_measures(const BodyModel& body, const MotionMeasures& measures, const FinalPosture& ends,
                  Json& json);

// Why a candidate is not possible: numbers of each kind, and the sentence that says them.
[[nodiscard]] Json reasons_to_json(const Judgement& judgement);

}  // namespace shigusa
