// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>
#include <shigusa/generate.hpp>
#include <span>
#include <vector>

#include "planner.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// The mixtures for the search of a Pareto front: each weighted criterion alone, up to three of them
// in pairs, and all together. User criteria belong to the last only.
[[nodiscard]] std::vector<CriteriaSettings> pareto_mixtures(const CriteriaSettings& criteria);

// The candidates that no other dominates (as good by every criterion and better by one).
[[nodiscard]] std::vector<Candidate> not_dominated(std::vector<Candidate> candidates);

// Selects at most `most` candidates of a front, spread apart: the best by each criterion, then
// repeatedly the one farthest from those taken, in penalties normalised by their range. The lowest
// score comes first.
[[nodiscard]] std::vector<Candidate> spread_over(std::vector<Candidate> front, int most);

// Searches on an approach by each mixture, with equal shares of the budget, and stores the front of
// all found motions as the candidates; adds the counts.
void search_front(const Task& task, const RunSettings& run, Planner& planner, std::size_t approach,
                  const Progress& progress, GenerateResult& generation);

}  // namespace shigusa
