// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/core/progress.hpp>
#include <span>
#include <vector>

namespace shigusa {

// The most coordinates that a point may have.
inline constexpr int kMaxGenes = 10000;

// A minimisation over the unit cube. Searches know numbers, never bodies; batch evaluation is the
// one seam between them and what is searched.
struct SearchProblem {
  int genes = 0;  // coordinates of a point, 1..kMaxGenes

  // Scores `count` points: `points` is (count × genes), each coordinate in [0, 1]; `scores` is
  // (count), lower is better. A NaN score, or one left unwritten, is treated as the worst.
  std::function<void(std::span<const double> points, std::span<double> scores)> evaluate{};

  // A guess, (genes) in [0, 1]; empty: the middle. Searches over real numbers score it first and go
  // out from there; those over codes draw their first points by chance.
  std::vector<double> start{};
};

// A point with its score.
struct Individual {
  std::vector<double> point;  // (genes) in [0, 1]
  double score = 0.0;         // lower is better; +infinity where the problem gave NaN

  friend bool operator==(const Individual&, const Individual&) = default;
};

// Why a search ended.
enum class SearchEnd {
  converged,  // by itself
  budget,     // all evaluations are used up
  cancelled,  // by the caller, or by a deadline
};

// The result of a search.
//
// Every search is anytime: its budget decides where it stops and nothing else. The points that are
// scored with one budget are the first of those scored with a larger one, so with the same seed
// more budget never gives a worse best_seen.
struct SearchResult {
  std::vector<Individual> final_population;  // what the search ended with: see each search
  Individual best_seen;                      // the best of all evaluated; the first among equals
  int evaluations = 0;                       // points scored
  int rejected_nan = 0;                      // scores that were NaN
  int generations = 0;                       // completed after the initial population
  SearchEnd end = SearchEnd::budget;         // why it ended
};

// The final population, each point once, lowest score first; equal ones in their order.
[[nodiscard]] std::vector<Individual> ranked_population(const SearchResult& result);

}  // namespace shigusa
