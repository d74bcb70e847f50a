// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/search.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa::bench {

// The compared optimisers of pagmo2 (F. Biscani and D. Izzo, J. Open Source Software 5 (2020)
// 2338): "CMA-ES", "DE", "SADE", "SGA". Empty in a build without it.
[[nodiscard]] std::span<const std::string> pagmo_searches();

// Minimises with one of them and its default settings, for each of the seeds 1..seeds: a population
// of the problem's start and random points, restarted from a new one if it ends within the budget.
// Returns the best scores (seeds × budgets) among the first b points of each run. pagmo requests
// one point at a time, so the runs proceed in parallel and their pending points are scored in one
// call.
[[nodiscard]] std::vector<std::vector<double>> run_pagmo(const std::string& name,
                                                         const SearchProblem& problem, int seeds,
                                                         const std::vector<int>& budgets);

}  // namespace shigusa::bench
