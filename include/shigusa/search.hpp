// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/run.hpp>
#include <span>
#include <vector>

namespace shigusa {

/// Largest number of coordinates of a point.
inline constexpr int kMaxGenes = 10000;

/// A minimisation problem over the unit cube. Searches are independent of bodies and see the
/// problem only through batch evaluation.
struct SearchProblem {
  int genes = 0;  ///< number of coordinates, 1..kMaxGenes

  /// Scores `count` points: `points` is (count × genes), each coordinate in [0, 1]; `scores` is
  /// (count), lower is better. A NaN score, or one left unwritten, is treated as the worst.
  std::function<void(std::span<const double> points, std::span<double> scores)> evaluate{};

  /// Initial guess, (genes) in [0, 1]; empty: the middle. Searches over real numbers score it first
  /// and start from it; searches over codes start from random points.
  std::vector<double> start{};
};

/// A point and its score.
struct Individual {
  std::vector<double> point;  ///< (genes) in [0, 1]
  double score = 0.0;         ///< lower is better; +infinity where the problem gave NaN

  friend bool operator==(const Individual&, const Individual&) = default;
};

/// Why a search ended.
enum class SearchEnd {
  converged,  ///< the search converged
  budget,     ///< all evaluations were used
  cancelled,  ///< cancelled by the caller or a deadline
};
/// The words of SearchEnd.
template <>
inline constexpr std::array kEnumWords<SearchEnd>{
    EnumWord{SearchEnd::converged, "converged"},
    EnumWord{SearchEnd::budget, "budget"},
    EnumWord{SearchEnd::cancelled, "cancelled"},
};

/// The result of a search.
///
/// Every search is an anytime algorithm: its budget only decides when it stops, and the points
/// scored with one budget are the first ones scored with a larger budget. This does not hold for
/// generate(), which divides its budget among several searches and may return a worse first
/// candidate for a larger budget.
struct SearchResult {
  std::vector<Individual> final_population;  ///< population at the end, specific to each search
  Individual best_seen;                      ///< best point evaluated; the first among equals
  int evaluations = 0;                       ///< points scored
  int rejected_nan = 0;                      ///< scores that were NaN
  int generations = 0;                       ///< generations after the initial population
  SearchEnd end = SearchEnd::budget;         ///< reason for the end
};

/// The distinct points of the final population by ascending score; ties keep their order.
[[nodiscard]] std::vector<Individual> ranked_population(const SearchResult& result);

/// The paper's constants (section 3.2), each listed in docs/paper_map.md.
inline constexpr int kPaperBitsPerGene = 4;         ///< bits of a gene
inline constexpr int kPaperPopulation = 8;          ///< genomes of a population
inline constexpr double kPaperCrossoverRate = 0.5;  ///< probability of a crossover
inline constexpr double kPaperMutationRate = 0.1;   ///< probability of a mutation
inline constexpr int kPaperMaxGenerations = 20;     ///< generations at most
inline constexpr int kPaperUnchangedGenerations =
    3;  ///< unchanged generations until convergence (rule R7)
inline constexpr double kPaperFitnessOffset = 0.05;  ///< F = 1 / (offset + score) (rule R7)

/// Settings of the paper's genetic algorithm.
struct GeneticSettings {
  int bits_per_gene = kPaperBitsPerGene;                   ///< 1..16
  int population = kPaperPopulation;                       ///< even, 2..1000
  double crossover_rate = kPaperCrossoverRate;             ///< per pair, 0..1
  double mutation_rate = kPaperMutationRate;               ///< per individual, 0..1
  int max_generations = kPaperMaxGenerations;              ///< ≥ 0
  int unchanged_generations = kPaperUnchangedGenerations;  ///< ≥ 1
  double fitness_offset = kPaperFitnessOffset;             ///< 1e-12..1e12
  std::uint64_t seed = 0;    ///< random seed; the same seed gives the same search
  std::uint64_t stream = 0;  ///< random stream within a seed, for restarts
  /// Largest number of genomes scored, ≥ population; empty: no limit.
  std::optional<int> max_evaluations{};
};

/// The search methods.
enum class SearchMethod {
  paper_ga,                ///< the paper's genetic algorithm, for the paper's weights 0..15
  log_ga,                  ///< the same algorithm for logarithmic weights
  annealing,               ///< simulated annealing
  cma_es,                  ///< covariance matrix adaptation: the default
  differential_evolution,  ///< differential evolution
  random,                  ///< uniformly random points
};

/// A search function with default settings and a budget of `evaluations` points. The same seed
/// gives the same result.
using SearchRun = SearchResult(const SearchProblem& problem, int evaluations, std::uint64_t seed,
                               const Progress& progress);
SearchRun genetic_by_default;    ///< the paper's genetic algorithm, with restarts
SearchRun annealing_by_default;  ///< simulated annealing with parallel chains
SearchRun cma_es_by_default;     ///< covariance matrix adaptation with restarts
SearchRun evolution_by_default;  ///< differential evolution with self-adaptive rates
SearchRun random_by_default;     ///< uniformly random points, as a baseline

/// A user-defined search. It must score at most `evaluations` points of the problem and return the
/// best one seen; the final population may be empty.
using SearchFunction = std::function<SearchRun>;

/// The facts about a search method.
struct SearchInfo {
  SearchMethod method;    ///< the method
  std::string_view word;  ///< word in files
  bool paper_code;        ///< searches the paper's weights 0..15 in presets that have them
  bool genetic;           ///< converges by itself, and is restarted until its budget is used
  SearchRun* run;         ///< the search function
};

/// All search methods, in the order of SearchMethod.
inline constexpr std::array kSearches{
    SearchInfo{SearchMethod::paper_ga, "paper_ga", true, true, genetic_by_default},
    SearchInfo{SearchMethod::log_ga, "log_ga", false, true, genetic_by_default},
    SearchInfo{SearchMethod::annealing, "annealing", true, false, annealing_by_default},
    SearchInfo{SearchMethod::cma_es, "cma_es", false, false, cma_es_by_default},
    SearchInfo{SearchMethod::differential_evolution, "de", false, false, evolution_by_default},
    SearchInfo{SearchMethod::random, "random", true, false, random_by_default},
};
/// The words of SearchMethod.
template <>
inline constexpr auto kEnumWords<SearchMethod> = words_of_table(kSearches, &SearchInfo::method);

/// The row of a search method.
[[nodiscard]] constexpr const SearchInfo& info_of(SearchMethod method) {
  return kSearches[static_cast<std::size_t>(method)];
}

/// Minimises a problem with a method's default settings. `evaluations` is the whole budget, at
/// least 1, for genetic methods at least kPaperPopulation. paper_ga and log_ga are one algorithm
/// here, since the problem defines the meaning of the codes.
[[nodiscard]] inline SearchResult search(SearchMethod method, const SearchProblem& problem,
                                         int evaluations, std::uint64_t seed,
                                         const Progress& progress = {}) {
  return info_of(method).run(problem, evaluations, seed, progress);
}

}  // namespace shigusa
