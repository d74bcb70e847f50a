// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <shigusa/random.hpp>
#include <span>
#include <vector>

namespace shigusa {

// The constants of the covariance matrix adaptation for n genes and a population of λ: table 1 and
// equations 49 to 58 of Hansen's tutorial (arXiv 1604.00772).
struct CmaConstants {
  CmaConstants(int genes, int population);

  std::vector<double> weights;  // (population), the best first; the second half negative
  double mu_eff = 0.0;          // variance-effective size of the better half
  double c_sigma = 0.0;         // rate of the path of steps
  double d_sigma = 0.0;         // damping of the step size
  double c_path = 0.0;          // rate of the path of the covariance
  double c_one = 0.0;           // rate of the rank-one update
  double c_mu = 0.0;            // rate of the rank-μ update
  double expected_norm = 0.0;   // of a normal vector of n components
};

// One run of the covariance matrix adaptation, a generation at a time: sample(), then update() with
// the scores.
class CmaRun {
 public:
  // mean (genes) in [0, 1]; step > 0; population ≥ 4.
  CmaRun(std::vector<double> mean, double step, int population);

  // The next generation, (population × genes) in [0, 1].
  [[nodiscard]] const std::vector<double>& sample(Random& random);

  // Takes the mean, if it lies in the cube, for the first point of the sample.
  void put_mean_first();

  // scores (population) of the sample; lower is better.
  void update(std::span<const double> scores);

  // The largest standard deviation along a coordinate.
  [[nodiscard]] double spread() const;
  // The covariance has lost its numerical rank, or numbers overflowed; nothing more can be sampled.
  [[nodiscard]] bool degenerate() const { return degenerate_; }
  [[nodiscard]] int population() const { return static_cast<int>(constants_.weights.size()); }
  [[nodiscard]] double step() const { return step_; }

 private:
  [[nodiscard]] std::vector<double> penalised(std::span<const double> scores) const;
  void move_mean(std::span<const std::size_t> order);
  void adapt_covariance(std::span<const std::size_t> order);
  void adapt_step();
  void factorise();

  std::size_t n_;
  CmaConstants constants_;
  int generation_ = 0;
  std::vector<double> mean_;        // (n); may lie outside of the cube by a little
  double step_;                     // σ
  std::vector<double> covariance_;  // C (n × n), the lower triangle
  std::vector<double> factor_;      // Lᵀ (n × n), the upper triangle, C = L Lᵀ
  std::vector<double> path_sigma_;  // (n) in the coordinates of z
  std::vector<double> path_c_;      // (n)
  std::vector<double> z_;           // (population × n) standard normal
  std::vector<double> y_;           // (population × n) = L z
  std::vector<double> points_;      // (population × n) = mean + σ y, brought into the cube
  std::vector<double> excess_;      // (population) mean square of what that took off, in deviations
  bool heeds_path_ = true;          // the tutorial's h_σ
  bool degenerate_ = false;
};

}  // namespace shigusa
