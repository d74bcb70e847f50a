// SPDX-License-Identifier: MIT
#include "idle_limb_search.hpp"

#include <shigusa/scalar.hpp>
#include <shigusa/search.hpp>

namespace shigusa {
namespace {

struct Range {
  double low;
  double high;

  // rounding could take the last share beyond the range
  [[nodiscard]] double at(double share) const { return min(high, low + share * (high - low)); }
  [[nodiscard]] double share(double value) const {
    return high > low ? clamp((value - low) / (high - low), 0.0, 1.0) : 0.0;
  }
};

}  // namespace

void search_finals(std::span<const Layer> layers, std::uint64_t seed, const RestEvaluation& score,
                   std::vector<double>& finals) {
  std::vector<Range> ranges;
  for (const Layer& layer : layers) {
    for (const ParameterInfo& info : layer.parameters) {
      if (info.kind == ParameterKind::final_angle) ranges.push_back({info.low, info.high});
    }
  }
  if (ranges.empty()) return;
  const auto angles_of = [&ranges](std::span<const double> points) {
    std::vector<double> angles;
    for (std::size_t k = 0; k < points.size(); ++k) {
      angles.push_back(ranges[k % ranges.size()].at(points[k]));
    }
    return angles;
  };
  SearchProblem problem;
  problem.genes = static_cast<int>(ranges.size());
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    problem.start.push_back(ranges[k].share(finals[k]));
  }
  problem.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    score(angles_of(points), scores);
  };
  // the motion as it is, which no rounding of shares may lose
  double before = 0.0;
  score(finals, std::span(&before, 1));
  const SearchResult found =
      search(SearchMethod::cma_es, problem, kRestEvaluations * problem.genes, seed);
  if (found.best_seen.score < before) finals = angles_of(found.best_seen.point);
}

}  // namespace shigusa
