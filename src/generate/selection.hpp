// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <span>
#include <string>
#include <vector>

#include "generate/archive.hpp"

namespace shigusa {

// The points of a search that are worth a replay, best first, and those that are not.
struct Selection {
  std::vector<Individual> picked;
  std::vector<Archived> spare{};  // for where those picked will not do, best first
  int similar = 0;                // of those not delivered, that end as a better one does
  int worse = 0;                  // score more than kCandidateSpread worse than the best
};

// Picks at most `most` points of all that a search came upon, which end differently and are not
// much worse than the best: first the best of each style, then the others, best first. All others
// are spare.
[[nodiscard]] Selection distinct_postures(const Archive& archive, int most);

// Whether a candidate ends less than `apart` (rad) from where an archived motion does.
[[nodiscard]] bool ends_like(const Candidate& candidate, const Archived& archived, double apart);

// The number of spare points little worse than the best that end nearly as a candidate does, less
// the `taken` ones, which became candidates themselves.
[[nodiscard]] int count_similar(const Selection& selection, std::span<const Candidate> candidates,
                                int taken);

// Why there are fewer candidates than the task asks for; empty where there are not.
[[nodiscard]] Message why_fewer(const Task& task, const GenerateResult& generation,
                                const Selection& selection);

}  // namespace shigusa
