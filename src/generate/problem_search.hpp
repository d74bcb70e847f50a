// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>

#include "planner.hpp"

namespace shigusa {

// One search of a problem, with its candidates delivered. `on_all`: on all approaches if the first
// leads to no possible motion. Fails if the planner cannot be made or check_values fails.
[[nodiscard]] Result<GenerateResult> search_problem(const Problem& problem, const RunSettings& run,
                                                    const Progress& progress, bool on_all);

// The candidate of the given values; at the edge of reach, by another posture if the usual one
// misses.
[[nodiscard]] Candidate played(Planner& planner, const Parameters& values);

// The candidates of a result replayed on another problem of the same body and goals.
[[nodiscard]] Result<GenerateResult> played_anew(const Problem& problem,
                                                 const GenerateResult& generation);

// Sets possible_in of all candidates that lack it.
void find_possible_in(const BodyModel& body, GenerateResult& generation);

// Sets the status from all candidates, and the remaining distance and turn from the first.
void tell_status(bool in_reach, GenerateResult& generation);

}  // namespace shigusa
