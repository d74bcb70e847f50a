// SPDX-License-Identifier: MIT
#include "population.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <shigusa/math.hpp>
#include <utility>

namespace shigusa {

std::span<const double> point_of(std::span<const double> points, std::size_t i, std::size_t genes) {
  return points.subspan(i * genes, genes);
}

void set_point(std::span<double> points, std::size_t i, std::span<const double> point) {
  std::copy(point.begin(), point.end(), points.subspan(i * point.size(), point.size()).begin());
}

std::vector<std::size_t> ranked(std::span<const double> scores) {
  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
  return order;
}

double reflected(double x) {
  if (x >= 0.0 && x <= 1.0) return x;
  if (!is_finite(x)) return 0.0;
  // beyond 2^52 there is no fraction left to reflect
  if (abs(x) > 1e15) return 0.0;
  const double half = 0.5 * abs(x);
  const double period = 2.0 * (half - static_cast<double>(static_cast<long long>(half)));
  return period <= 1.0 ? period : 2.0 - period;
}

void keep_best(std::vector<Individual>& best, std::span<const double> points,
               std::span<const double> scores, std::size_t keep) {
  if (scores.empty()) return;
  const std::size_t genes = points.size() / scores.size();
  for (const std::size_t i : ranked(scores)) {
    if (best.size() >= keep && scores[i] >= best.back().score) break;
    const auto place =
        std::upper_bound(best.begin(), best.end(), scores[i],
                         [](double score, const Individual& other) { return score < other.score; });
    const std::span<const double> point = point_of(points, i, genes);
    best.insert(place, Individual{{point.begin(), point.end()}, scores[i]});
    if (best.size() > keep) best.pop_back();
  }
}

std::vector<Individual> ranked_population(const SearchResult& result) {
  std::vector<Individual> ranked;
  std::set<std::vector<double>> known;
  for (const Individual& individual : result.final_population) {
    if (known.insert(individual.point).second) ranked.push_back(individual);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Individual& a, const Individual& b) { return a.score < b.score; });
  return ranked;
}

}  // namespace shigusa
