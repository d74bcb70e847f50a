// SPDX-License-Identifier: MIT
#include "scorer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/check.hpp"
#include "core/index.hpp"

namespace shigusa {
namespace {

void check(const SearchProblem& problem, int budget) {
  SHG_CHECK(problem.evaluate != nullptr, "the problem has no evaluate function");
  SHG_CHECK(problem.genes >= 1 && problem.genes <= kMaxGenes,
            fmt::format("genes is {}, allowed: 1..{}", problem.genes, kMaxGenes));
  SHG_CHECK(problem.start.empty() || problem.start.size() == index(problem.genes),
            fmt::format("start has {} coordinates, allowed: none or {}", problem.start.size(),
                        problem.genes));
  for (const double x : problem.start) {
    SHG_CHECK(x >= 0.0 && x <= 1.0, fmt::format("start has a coordinate of {}, allowed: 0..1", x));
  }
  SHG_CHECK(budget >= 1, fmt::format("evaluations is {}, allowed: 1 and more", budget));
}

}  // namespace

Scorer::Scorer(const SearchProblem& problem, int budget, const Progress& progress)
    : problem_(problem), progress_(progress), budget_(budget) {
  check(problem, budget);
}

std::vector<double> Scorer::start() const {
  if (!problem_.start.empty()) return problem_.start;
  return std::vector<double>(index(problem_.genes), 0.5);
}

int Scorer::score(std::span<const double> points, std::span<double> scores) {
  const std::size_t genes = index(problem_.genes);
  const std::size_t count = std::min(scores.size(), index(left()));
  std::fill(scores.begin(), scores.end(), std::numeric_limits<double>::quiet_NaN());
  if (count > 0) problem_.evaluate(points.first(count * genes), scores.first(count));
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (std::isnan(scores[i])) {
      scores[i] = kWorst;
      if (i < count) ++result_.rejected_nan;
    }
    if (i >= count || (result_.evaluations++ > 0 && scores[i] >= result_.best_seen.score)) continue;
    const std::span<const double> point = points.subspan(i * genes, genes);
    result_.best_seen.point.assign(point.begin(), point.end());
    result_.best_seen.score = scores[i];
  }
  return static_cast<int>(count);
}

void Scorer::report(double fraction) const {
  if (!progress_.report) return;
  progress_.report({"search", fraction, result_.evaluations, result_.best_seen.score});
}

bool Scorer::step(std::span<const double> points, std::span<double> scores) {
  score(points, scores);
  report(static_cast<double>(result_.evaluations) / budget_);
  if (left() == 0) {
    result_.end = SearchEnd::budget;
    return false;
  }
  if (cancelled()) {
    result_.end = SearchEnd::cancelled;
    return false;
  }
  return true;
}

}  // namespace shigusa
