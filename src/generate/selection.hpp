// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>
#include <span>
#include <string>
#include <vector>

#include "generate/archive.hpp"

namespace shigusa {

// What is worth a replay, best first, and what was not.
struct Selection {
  std::vector<Individual> picked;
  std::vector<Archived> spare{};  // for where those picked will not do, best first
  int similar = 0;                // of those not delivered, that end as a better one does
  int worse = 0;                  // score more than kCandidateSpread worse than the best
};

// Of all that a search came upon, at most so many that end differently and are not much worse than
// the best: first the best of each style, then what is left, best first. Spare is all else that is
// not much worse.
[[nodiscard]] Selection distinct_postures(const Archive& archive, int most);

// Whether a candidate ends less than `apart` (rad) from where an archived motion does.
[[nodiscard]] bool ends_like(const Candidate& candidate, const Archived& archived, double apart);

// Of what is spare and little worse than the best, how many end all but as a candidate; without
// those that became one themselves, `taken`.
[[nodiscard]] int count_similar(const Selection& choice, std::span<const Candidate> candidates,
                                int taken);

// Why there are fewer candidates than the task asks for; empty where there are not.
[[nodiscard]] std::string why_fewer(const Task& task, const GenerateResult& generation,
                                    const Selection& choice);

}  // namespace shigusa
