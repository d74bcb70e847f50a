// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/criteria.hpp>
#include <span>
#include <vector>

namespace shigusa {

// Penalties (motions) of a user-defined criterion; of NaN where the value is NaN.
[[nodiscard]] std::vector<double> penalties_of(const UserCriterion& user, const BodyModel& body,
                                               std::span<const Motion> motions);

// Scores (motions) of motions of equal shapes, worst_score for none: user-defined criteria are
// asked once for all, on the calling thread, the built-in ones on `threads` threads (0: one per
// core).
void score_motions(const BodyModel& body, std::span<std::optional<Motion>> motions,
                   const CriteriaSettings& settings, const CriteriaContext& context, int threads,
                   std::span<double> scores);

}  // namespace shigusa
