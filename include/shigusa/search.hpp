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

/// The most coordinates that a point may have.
inline constexpr int kMaxGenes = 10000;

/// A minimisation over the unit cube. Searches know numbers, never bodies; batch evaluation is the
/// one seam between them and what is searched.
struct SearchProblem {
  int genes = 0;  ///< coordinates of a point, 1..kMaxGenes

  /// Scores `count` points: `points` is (count × genes), each coordinate in [0, 1]; `scores` is
  /// (count), lower is better. A NaN score, or one left unwritten, is treated as the worst.
  std::function<void(std::span<const double> points, std::span<double> scores)> evaluate{};

  /// A guess, (genes) in [0, 1]; empty: the middle. Searches over real numbers score it first and
  /// go out from there; those over codes draw their first points by chance.
  std::vector<double> start{};
};

/// A point with its score.
struct Individual {
  std::vector<double> point;  ///< (genes) in [0, 1]
  double score = 0.0;         ///< lower is better; +infinity where the problem gave NaN

  friend bool operator==(const Individual&, const Individual&) = default;
};

/// Why a search ended.
enum class SearchEnd {
  converged,  ///< by itself
  budget,     ///< all evaluations are used up
  cancelled,  ///< by the caller, or by a deadline
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
/// Every search here is anytime: its budget decides where it stops and nothing else, and the points
/// that are scored with one budget are the first of those scored with a larger one. That is of one
/// search of one problem: generate() divides its budget among several and delivers what can be
/// played, and may end with a worse first candidate where its budget is larger.
struct SearchResult {
  std::vector<Individual> final_population;  ///< what the search ended with: see each search
  Individual best_seen;                      ///< the best of all evaluated; the first among equals
  int evaluations = 0;                       ///< points scored
  int rejected_nan = 0;                      ///< scores that were NaN
  int generations = 0;                       ///< completed after the initial population
  SearchEnd end = SearchEnd::budget;         ///< why it ended
};

/// The final population, each point once, lowest score first; equal ones in their order.
[[nodiscard]] std::vector<Individual> ranked_population(const SearchResult& result);

/// The paper's numbers (section 3.2); each is in docs/paper_map.md.
inline constexpr int kPaperBitsPerGene = 4;           ///< 4 ビットの 2 進コード
inline constexpr int kPaperPopulation = 8;            ///< 8 パターンの個体群
inline constexpr double kPaperCrossoverRate = 0.5;    ///< 交叉確率は 0.5
inline constexpr double kPaperMutationRate = 0.1;     ///< 突然変位率は 0.1
inline constexpr int kPaperMaxGenerations = 20;       ///< 最大 20 世代
inline constexpr int kPaperUnchangedGenerations = 3;  ///< without change end it (rule R7)
inline constexpr double kPaperFitnessOffset = 0.05;   ///< F = 1 / (offset + score) (rule R7)

/// The settings of the paper's genetic algorithm.
struct GeneticSettings {
  int bits_per_gene = kPaperBitsPerGene;                   ///< 1..16
  int population = kPaperPopulation;                       ///< even, 2..1000
  double crossover_rate = kPaperCrossoverRate;             ///< per pair, 0..1
  double mutation_rate = kPaperMutationRate;               ///< per individual, 0..1
  int max_generations = kPaperMaxGenerations;              ///< ≥ 0
  int unchanged_generations = kPaperUnchangedGenerations;  ///< ≥ 1
  double fitness_offset = kPaperFitnessOffset;             ///< 1e-12..1e12
  std::uint64_t seed = 0;                                  ///< the same seed gives the same search
  std::uint64_t stream = 0;  ///< other random numbers for the same seed: restarts
  /// genomes that may be scored, ≥ population; absent: no limit
  std::optional<int> max_evaluations{};
};

/// The searches that there are.
enum class SearchMethod {
  paper_ga,                ///< the paper's genetic algorithm, for the paper's weights 0..15
  log_ga,                  ///< the same, for logarithmic weights
  annealing,               ///< simulated annealing
  cma_es,                  ///< covariance matrix adaptation: the default
  differential_evolution,  ///< differential evolution
  random,                  ///< uniformly random points
};

/// A search by its default settings, with a budget of `evaluations` points. The same seed gives the
/// same result.
using SearchRun = SearchResult(const SearchProblem& problem, int evaluations, std::uint64_t seed,
                               const Progress& progress);
SearchRun genetic_by_default;    ///< the paper's genetic algorithm, again and again
SearchRun annealing_by_default;  ///< simulated annealing, several chains side by side
SearchRun cma_es_by_default;     ///< covariance matrix adaptation with restarts
SearchRun evolution_by_default;  ///< differential evolution with rates that adapt themselves
SearchRun random_by_default;     ///< uniformly random points, the yardstick of the others

/// A search of one's own, called as these are. It scores at most `evaluations` points of the
/// problem, and returns the best it saw, and a final population that may be empty.
using SearchFunction = std::function<SearchRun>;

/// The facts about a method.
struct SearchInfo {
  SearchMethod method;    ///< that they are about
  std::string_view word;  ///< in files
  bool paper_code;        ///< where a preset has the paper's weights 0..15, it searches these
  bool genetic;           ///< it converges by itself, and is restarted until its budget is used up
  SearchRun* run;         ///< runs it
};

/// All methods, in the order of SearchMethod.
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

/// The facts about one method.
[[nodiscard]] constexpr const SearchInfo& info_of(SearchMethod method) {
  return kSearches[static_cast<std::size_t>(method)];
}

/// Minimises with a method's default settings. `evaluations` is the whole budget, the same for each
/// method; at least 1, for the genetic ones at least kPaperPopulation. paper_ga and log_ga are one
/// algorithm here: what their codes mean is the problem's affair.
[[nodiscard]] inline SearchResult search(SearchMethod method, const SearchProblem& problem,
                                         int evaluations, std::uint64_t seed,
                                         const Progress& progress = {}) {
  return info_of(method).run(problem, evaluations, seed, progress);
}

}  // namespace shigusa
