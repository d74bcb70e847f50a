// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

// Bounds for tests that count random events. With fixed seeds such a test always gives the same
// answer; a correct implementation violates the bounds for one seed in a million.
namespace shigusa::testing_support {

// Half width of the interval around n p that holds a binomial count: five standard deviations,
// outside of which lies 6e-7 of a normal distribution.
inline double binomial_tolerance(double n, double p) { return 5.0 * std::sqrt(n * p * (1.0 - p)); }

// Pearson's statistic Σ (count - expected)² / expected; each expected count should be 5 or more.
inline double chi_square(const std::vector<int>& counts, const std::vector<double>& probabilities) {
  const double n = std::accumulate(counts.begin(), counts.end(), 0.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double expected = n * probabilities[i];
    sum += (counts[i] - expected) * (counts[i] - expected) / expected;
  }
  return sum;
}

// The same, for counts that should all be equal.
inline double chi_square_uniform(const std::vector<int>& counts) {
  const double share = 1.0 / static_cast<double>(counts.size());
  return chi_square(counts, std::vector<double>(counts.size(), share));
}

// A chi-square variable of k degrees of freedom exceeds k + 2 √(k x) + 2 x with probability at most
// e^-x (Laurent and Massart 2000, lemma 1); here e^-14 = 8e-7.
inline double chi_square_limit(std::size_t degrees_of_freedom) {
  const double k = static_cast<double>(degrees_of_freedom);
  constexpr double x = 14.0;
  return k + 2.0 * std::sqrt(k * x) + 2.0 * x;
}

}  // namespace shigusa::testing_support
