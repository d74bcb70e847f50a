// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <span>
#include <string>
#include <vector>

#include "generate/archive.hpp"

namespace shigusa {

// The points of a search to replay, best first, and the rest.
struct Selection {
  std::vector<Individual> picked;
  std::vector<Archived> spare{};  // replacements for picked points, best first
  int similar = 0;                // not delivered, as they look like a better one
  int worse = 0;                  // more than kCandidateSpread worse than the best
};

// Picks at most `most` archived points that look different and are not much worse than the best:
// first the best of each style, then the others, best first. The rest are spare.
[[nodiscard]] Selection distinct_postures(const Archive& archive, int most);

// Number of spare points little worse than the best that look like a candidate, less the `taken`
// ones, which became candidates.
[[nodiscard]] int count_similar(const Selection& selection, std::span<const Look> candidates,
                                int taken);

// The reason for fewer candidates than the task asks for; empty if there are enough.
[[nodiscard]] Message why_fewer(const Task& task, const GenerateResult& generation,
                                const Selection& selection);

}  // namespace shigusa
