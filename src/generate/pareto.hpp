// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>
#include <shigusa/generate.hpp>
#include <span>
#include <vector>

#include "planner.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// The mixtures that a Pareto front is searched by: each criterion that has a weight alone, up to
// three of them in pairs, and all as they are. The user's own belong to the last only.
[[nodiscard]] std::vector<CriteriaSettings> pareto_mixtures(const CriteriaSettings& criteria);

// The candidates that no other one dominates: is as good as by every criterion and better by one.
[[nodiscard]] std::vector<Candidate> not_dominated(std::vector<Candidate> candidates);

// At most `most` candidates of a front, as far apart as can be: the best by each criterion, then
// again and again the one that is farthest from those taken, in penalties over their range. The
// lowest score comes first.
[[nodiscard]] std::vector<Candidate> spread_over(std::vector<Candidate> front, int most);

// Searches on an approach by each mixture, with an equal share of the budget, and puts the front of
// all that these searches keep into the generation's candidates; adds to its counts.
void search_front(const Task& task, const RunSettings& run, Planner& planner, std::size_t approach,
                  const Progress& progress, GenerateResult& generation);

}  // namespace shigusa
