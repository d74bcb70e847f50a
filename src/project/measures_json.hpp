// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/criteria/collision.hpp>
#include <shigusa/criteria/support_margin.hpp>
#include <shigusa/hierarchy/final_posture.hpp>
#include <shigusa/hierarchy/generator.hpp>
#include <vector>

#include "json_text.hpp"

namespace shigusa {

// What is told of generated and of recorded motions alike, as summary.json and the object of
// `shigusa score --json` have it: `over_limit`, `support` (of a body that stands), `collision`
// (where there is one) and `final_posture`.
void add_measures(const std::vector<LimitExcess>& over_limit,
                  const std::optional<SupportMargins>& support, const CollisionFound& collides,
                  const FinalPosture& ends, Json& json);

}  // namespace shigusa
