// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <shigusa/search.hpp>
#include <span>
#include <vector>

namespace shigusa {

// The score that replaces a NaN.
inline constexpr double kWorst = std::numeric_limits<double>::infinity();

// Scores batches of a search's points within the budget, and keeps the counts and the best point.
class Scorer {
 public:
  // Throws PreconditionError for a problem outside the ranges of SearchProblem and a budget below
  // 1.
  Scorer(const SearchProblem& problem, int budget, const Progress& progress);

  [[nodiscard]] int genes() const { return problem_.genes; }
  // The problem's start, or the centre of the cube.
  [[nodiscard]] std::vector<double> start() const;
  // Evaluations left of the budget.
  [[nodiscard]] int left() const { return budget_ - result_.evaluations; }

  // Scores points (count × genes) in order, in one call, within the budget, and returns the number
  // scored; scores (count) of the others are kWorst.
  int score(std::span<const double> points, std::span<double> scores);

  // Reports the progress to the caller.
  void report(double fraction) const;
  [[nodiscard]] bool cancelled() const { return progress_.cancelled(); }

  // Calls score() and report(); false when the search must end: budget used up, or cancelled.
  bool step(std::span<const double> points, std::span<double> scores);

  [[nodiscard]] SearchResult& result() { return result_; }
  [[nodiscard]] const SearchResult& result() const { return result_; }

 private:
  const SearchProblem& problem_;
  const Progress& progress_;
  int budget_;
  SearchResult result_;
};

}  // namespace shigusa
