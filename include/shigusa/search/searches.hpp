// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <shigusa/core/enum_words.hpp>
#include <shigusa/search/annealing.hpp>
#include <shigusa/search/cma_es.hpp>
#include <shigusa/search/differential_evolution.hpp>
#include <shigusa/search/genetic.hpp>
#include <shigusa/search/random_search.hpp>
#include <type_traits>

namespace shigusa {

enum class SearchMethod {
  paper_ga,                // restarted_genetic_search, for the paper's weights 0..15
  log_ga,                  // the same, for logarithmic weights
  annealing,               // annealing_search
  cma_es,                  // cma_es_search: the default
  differential_evolution,  // differential_evolution_search
  random,                  // random_search
};

// A search of one's own, called as these are. It scores at most `evaluations` points of the
// problem, and returns the best it saw, and a final population that may be empty.
using SearchFunction = std::function<SearchResult(const SearchProblem& problem, int evaluations,
                                                  std::uint64_t seed, const Progress& progress)>;

// What there is to know of a method.
struct SearchInfo {
  SearchMethod method;
  std::string_view word;
  bool paper_code;  // where a preset has the paper's weights 0..15, it searches these
  bool genetic;     // it converges by itself, and is restarted until its budget is used up
  SearchResult (*run)(const SearchProblem&, int evaluations, std::uint64_t seed, const Progress&);
};

// Runs a search by default settings.
template <auto Search, class Settings>
SearchResult run_by_default(const SearchProblem& problem, int evaluations, std::uint64_t seed,
                            const Progress& progress) {
  Settings settings;
  settings.seed = seed;
  if constexpr (std::is_same_v<Settings, GeneticSettings>) {
    return Search(problem, settings, evaluations, progress);
  } else {
    settings.evaluations = evaluations;
    return Search(problem, settings, progress);
  }
}

inline constexpr std::array kSearches{
    SearchInfo{SearchMethod::paper_ga, "paper_ga", true, true,
               run_by_default<restarted_genetic_search, GeneticSettings>},
    SearchInfo{SearchMethod::log_ga, "log_ga", false, true,
               run_by_default<restarted_genetic_search, GeneticSettings>},
    SearchInfo{SearchMethod::annealing, "annealing", true, false,
               run_by_default<annealing_search, AnnealingSettings>},
    SearchInfo{SearchMethod::cma_es, "cma_es", false, false,
               run_by_default<cma_es_search, CmaEsSettings>},
    SearchInfo{SearchMethod::differential_evolution, "de", false, false,
               run_by_default<differential_evolution_search, DifferentialEvolutionSettings>},
    SearchInfo{SearchMethod::random, "random", true, false,
               run_by_default<random_search, RandomSettings>},
};
template <>
inline constexpr auto kEnumWords<SearchMethod> = words_of_table(kSearches, &SearchInfo::method);

[[nodiscard]] constexpr const SearchInfo& info_of(SearchMethod method) {
  return kSearches[static_cast<std::size_t>(method)];
}

// Minimises with a method's default settings. `evaluations` is the whole budget, the same for each
// method; at least 1, for the genetic ones at least kPaperPopulation. paper_ga and log_ga are one
// algorithm here: what their codes mean is the problem's affair.
[[nodiscard]] inline SearchResult search(SearchMethod method, const SearchProblem& problem,
                                         int evaluations, std::uint64_t seed,
                                         const Progress& progress = {}) {
  return info_of(method).run(problem, evaluations, seed, progress);
}

}  // namespace shigusa
