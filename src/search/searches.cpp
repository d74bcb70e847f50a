// SPDX-License-Identifier: MIT
#include <shigusa/core/check.hpp>
#include <shigusa/search/annealing.hpp>
#include <shigusa/search/cma_es.hpp>
#include <shigusa/search/differential_evolution.hpp>
#include <shigusa/search/genetic.hpp>
#include <shigusa/search/random_search.hpp>
#include <shigusa/search/searches.hpp>

namespace shigusa {

std::string_view search_name(SearchMethod method) {
  switch (method) {
    case SearchMethod::paper_ga:
      return "paper_ga";
    case SearchMethod::log_ga:
      return "log_ga";
    case SearchMethod::annealing:
      return "annealing";
    case SearchMethod::cma_es:
      return "cma_es";
    case SearchMethod::differential_evolution:
      return "de";
    case SearchMethod::random:
      return "random";
  }
  fail_check("no search method", "method");
}

std::optional<SearchMethod> search_method(std::string_view name) {
  for (const SearchMethod method : kSearchMethods) {
    if (search_name(method) == name) return method;
  }
  return std::nullopt;
}

SearchResult search(SearchMethod method, const SearchProblem& problem, int evaluations,
                    std::uint64_t seed, const Progress& progress) {
  switch (method) {
    case SearchMethod::paper_ga:
    case SearchMethod::log_ga:
      return restarted_genetic_search(problem, {.seed = seed}, evaluations, progress);
    case SearchMethod::annealing:
      return annealing_search(problem, {.evaluations = evaluations, .seed = seed}, progress);
    case SearchMethod::cma_es:
      return cma_es_search(problem, {.evaluations = evaluations, .seed = seed}, progress);
    case SearchMethod::differential_evolution:
      return differential_evolution_search(problem, {.evaluations = evaluations, .seed = seed},
                                           progress);
    case SearchMethod::random:
      return random_search(problem, {.evaluations = evaluations, .seed = seed}, progress);
  }
  fail_check("no search method", "method");
}

}  // namespace shigusa
