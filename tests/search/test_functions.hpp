// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <shigusa/math.hpp>
#include <shigusa/search.hpp>
#include <span>
#include <vector>

// Functions with known optima, all 0, and measures of a search on them.
namespace shigusa::testing_support {

using Function = std::function<double(std::span<const double>)>;

// The optimum lies in 0.2..0.8, at a different place in each coordinate.
inline double shift(std::size_t i) {
  return 0.2 + 0.6 * std::fmod(0.37 * static_cast<double>(i) + 0.29, 1.0);
}

// Σ (x - shift)²
inline double sphere(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - shift(i)) * (x[i] - shift(i));
  return sum;
}

// Σ 10^(4 i / (n - 1)) (x - shift)²: a condition of 10⁴ along the coordinates.
inline double ellipsoid(std::span<const double> x) {
  const double n = static_cast<double>(x.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double d = x[i] - shift(i);
    sum += std::pow(10.0, 4.0 * static_cast<double>(i) / (n - 1.0)) * d * d;
  }
  return sum;
}

// Σ 10^(4 i / (n - 1)) d_i², d = x - shift mirrored at the diagonal: a condition of 10⁴, with no
// axis along a coordinate.
inline double rotated_ellipsoid(std::span<const double> x) {
  const double n = static_cast<double>(x.size());
  double along = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) along += (x[i] - shift(i)) / n;
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double d = x[i] - shift(i) - 2.0 * along;
    sum += std::pow(10.0, 4.0 * static_cast<double>(i) / (n - 1.0)) * d * d;
  }
  return sum;
}

// Rosenbrock's valley on -2..2; the optimum is at 0.75 in all coordinates.
inline double rosenbrock(std::span<const double> x) {
  const auto z = [&](std::size_t i) { return 4.0 * x[i] - 2.0; };
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double off = z(i + 1) - z(i) * z(i);
    sum += 100.0 * off * off + (1.0 - z(i)) * (1.0 - z(i));
  }
  return sum;
}

// Rastrigin's on a width of 10.24: ten minima in each coordinate, the others 1 or more each.
inline double rastrigin(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double d = 10.24 * (x[i] - shift(i));
    sum += d * d + 10.0 * (1.0 - std::cos(2.0 * kPi * d));
  }
  return sum;
}

// The distances from the lower and upper faces in turn, Σ / n: the optimum is a corner.
inline double corner(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += i % 3 == 0 ? 1.0 - x[i] : x[i];
  return sum / static_cast<double>(x.size());
}

// A bowl whose centre is beyond the upper face in every second coordinate, minus its minimum in the
// cube, which is on those faces.
inline double bowl_beyond(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double d = x[i] - (i % 2 == 0 ? 0.4 : 1.2);
    sum += i % 2 == 0 ? d * d : d * d - 0.2 * 0.2;
  }
  return sum;
}

inline SearchProblem problem_of(int genes, Function function) {
  return {.genes = genes,
          .evaluate = [genes, function](std::span<const double> points, std::span<double> scores) {
            const auto n = static_cast<std::size_t>(genes);
            for (std::size_t i = 0; i < scores.size(); ++i) {
              scores[i] = function(points.subspan(i * n, n));
            }
          }};
}

// Records a problem's evaluations, point by point and batch by batch.
struct Record {
  std::vector<std::vector<double>> points;
  std::vector<double> scores;
  std::vector<std::size_t> batches;

  SearchProblem watch(SearchProblem problem) {
    const auto inner = problem.evaluate;
    const auto genes = static_cast<std::size_t>(problem.genes);
    problem.evaluate = [this, inner, genes](std::span<const double> asked,
                                            std::span<double> answers) {
      inner(asked, answers);
      batches.push_back(answers.size());
      scores.insert(scores.end(), answers.begin(), answers.end());
      for (std::size_t i = 0; i < answers.size(); ++i) {
        const auto point = asked.subspan(i * genes, genes);
        points.emplace_back(point.begin(), point.end());
      }
    };
    return problem;
  }

  // Evaluations until a score is not above the target; the largest int if none is.
  [[nodiscard]] int evaluations_to(double target) const {
    const auto hit =
        std::find_if(scores.begin(), scores.end(), [&](double score) { return score <= target; });
    if (hit == scores.end()) return std::numeric_limits<int>::max();
    return static_cast<int>(hit - scores.begin()) + 1;
  }
};

inline constexpr int kSeeds = 11;

// The median, over kSeeds seeds, of the evaluations that a search needs to reach the target.
template <class Search>  // (problem, seed)
int median_evaluations(int genes, const Function& function, double target, Search search) {
  std::vector<int> needed;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Record record;
    search(record.watch(problem_of(genes, function)), seed);
    needed.push_back(record.evaluations_to(target));
  }
  std::sort(needed.begin(), needed.end());
  return needed[kSeeds / 2];
}

// The median of the best scores.
template <class Search>  // (problem, seed) -> SearchResult
double median_best(int genes, const Function& function, Search search) {
  std::vector<double> best;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    best.push_back(search(problem_of(genes, function), seed).best_seen.score);
  }
  std::sort(best.begin(), best.end());
  return best[kSeeds / 2];
}

}  // namespace shigusa::testing_support
