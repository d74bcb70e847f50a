// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <shigusa/search/problem.hpp>
#include <string_view>

namespace shigusa {

enum class SearchMethod {
  paper_ga,                // restarted_genetic_search, for the paper's weights 0..15
  log_ga,                  // the same, for logarithmic weights
  annealing,               // annealing_search
  cma_es,                  // cma_es_search: the default
  differential_evolution,  // differential_evolution_search
  random,                  // random_search
};

inline constexpr std::array kSearchMethods{SearchMethod::paper_ga,
                                           SearchMethod::log_ga,
                                           SearchMethod::annealing,
                                           SearchMethod::cma_es,
                                           SearchMethod::differential_evolution,
                                           SearchMethod::random};

// "paper_ga", "log_ga", "annealing", "cma_es", "de", "random".
[[nodiscard]] std::string_view search_name(SearchMethod method);

// The method of that name; nothing for another word.
[[nodiscard]] std::optional<SearchMethod> search_method(std::string_view name);

// Minimises with a method's default settings. `evaluations` is the whole budget, the same for each
// method; at least 1, for the genetic ones at least kPaperPopulation. paper_ga and log_ga are one
// algorithm here: what their codes mean is the problem's affair.
[[nodiscard]] SearchResult search(SearchMethod method, const SearchProblem& problem,
                                  int evaluations, std::uint64_t seed,
                                  const Progress& progress = {});

// A search of one's own, called as these are. It scores at most `evaluations` points of the
// problem, and returns the best it saw, and a final population that may be empty.
using SearchFunction = std::function<SearchResult(const SearchProblem& problem, int evaluations,
                                                  std::uint64_t seed, const Progress& progress)>;

}  // namespace shigusa
