// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>

#include "planner.hpp"

namespace shigusa {

// One search of a problem, with its candidates delivered. `on_all`: on all approaches where the
// first leads to nothing possible. Fails where the planner cannot be made, or where check_values
// does.
[[nodiscard]] Result<GenerateResult> search_problem(const Problem& problem, const RunSettings& run,
                                                    const Progress& progress, bool on_all);

// The candidate that values make; by another posture at the edge of reach where the usual one
// misses.
[[nodiscard]] Candidate played(Planner& planner, const Parameters& values);

// A search's candidates as another problem plays them, of the same body and goals.
[[nodiscard]] Result<GenerateResult> played_anew(const Problem& problem,
                                                 const GenerateResult& generation);

// Sets the status by all candidates, and what is left to the goals by the first.
void tell_status(bool in_reach, GenerateResult& generation);

}  // namespace shigusa
