// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/search.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa::bench {

// The optimisers of pagmo2 (F. Biscani and D. Izzo, J. Open Source Software 5 (2020) 2338) that are
// compared: "CMA-ES", "DE", "SADE", "SGA". None where the program was built without it.
[[nodiscard]] std::span<const std::string> pagmo_searches();

// Minimises with one of them and its own defaults, once for each of the seeds 1..seeds: a
// population with the problem's start and random points, evolved again from another one when it
// ends before the budget is used up. Returns the best scores (seeds × budgets) among the first b
// points of each run. pagmo asks for one point at a time, so the runs go side by side, and the
// points that they wait for are scored in one call.
[[nodiscard]] std::vector<std::vector<double>> run_pagmo(const std::string& name,
                                                         const SearchProblem& problem, int seeds,
                                                         const std::vector<int>& budgets);

}  // namespace shigusa::bench
