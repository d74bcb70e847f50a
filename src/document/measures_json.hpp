// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

#include "formats/json_text.hpp"

namespace shigusa {

inline constexpr double kMillimetres = 1000.0;  // per metre

// Adds the measures shared by summary.json and the object of `shigusa score --json`: `most_loaded`,
// `over_limit`, `support` (standing bodies), `collision` (if there is one) and `final_posture`.
void add_measures(const BodyModel& body, const MotionMeasures& measures, const FinalPosture& ends,
                  Json& json);

// Penalties of a score, keyed by criterion name.
[[nodiscard]] Json penalties_to_json(const Score& score);

// Reasons why a candidate is not possible: counts of each kind, and the sentence that states them.
[[nodiscard]] Json reasons_to_json(const Judgement& judgement);

// Where a thing was put.
[[nodiscard]] Json placed_to_json(const PlacedThing& placed);

}  // namespace shigusa
