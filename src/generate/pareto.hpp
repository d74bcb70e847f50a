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

// Those of which none is at least as good by every criterion and better by one.
[[nodiscard]] std::vector<Candidate> not_dominated(std::vector<Candidate> candidates);

// At most so many of a front, as far apart as can be: the best by each criterion, then always the
// one farthest, in penalties over their range, from those taken. Lowest score first.
[[nodiscard]] std::vector<Candidate> spread_over(std::vector<Candidate> front, int most);

// Searches the last of the ways by each mixture, with an equal share of the budget, and puts the
// front of all that they keep into the generation's candidates; adds to its counts.
void search_front(const Task& task, Planner& planner, std::size_t approach,
                  const Progress& progress, GenerateResult& generation);

}  // namespace shigusa
