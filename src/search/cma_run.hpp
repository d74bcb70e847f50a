// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <shigusa/run.hpp>
#include <span>
#include <vector>

namespace shigusa {

// The part of the covariance that a run learns.
enum class CmaShape { whole, diagonal };

// The constants of the covariance matrix adaptation for n genes and a population of λ: table 1 and
// equations 49 to 58 of Hansen's tutorial (arXiv 1604.00772). A diagonal has n numbers to learn
// instead of n², so its rates are larger: by twice the (n + 2) / 3 of R. Ros and N. Hansen (A
// simple modification in CMA-ES achieving linear time and space complexity, PPSN 2008).
struct CmaConstants {
  CmaConstants(int genes, int population, CmaShape shape = CmaShape::whole);

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
  // Begins a run. mean (genes) in [0, 1]; step > 0; population ≥ 4.
  CmaRun(std::vector<double> mean, double step, int population, CmaShape shape = CmaShape::whole);

  // Multiplies the deviation along each coordinate by its scale, before the first sample. scales
  // (genes) > 0.
  void scale(std::span<const double> scales);

  // Draws the next generation, (population × genes) in [0, 1]. `mirrored`: the second half mirrors
  // the first at the mean, point by point.
  [[nodiscard]] const std::vector<double>& sample(Random& random, bool mirrored = false);

  // Learns the whole covariance from now on, starting with the present diagonal.
  void learn_whole();

  // Replaces the first point of the sample by the mean, which must lie in the cube.
  void put_mean_first();

  // Updates the distribution by the scores (population) of the sample; lower is better.
  void update(std::span<const double> scores);

  // The largest standard deviation along a coordinate.
  [[nodiscard]] double spread() const;
  // The covariance has lost its numerical rank, or numbers overflowed; sampling is no longer
  // possible.
  [[nodiscard]] bool degenerate() const { return degenerate_; }
  [[nodiscard]] int population() const { return static_cast<int>(constants_.weights.size()); }
  [[nodiscard]] double step() const { return step_; }

 private:
  [[nodiscard]] std::vector<double> penalised(std::span<const double> scores) const;
  void move_mean(std::span<const std::size_t> order);
  void adapt_covariance(std::span<const std::size_t> order);
  void adapt_step();
  void factorise();

  // First learnt column in row `i` of the covariance.
  [[nodiscard]] std::size_t first_column(std::size_t i) const {
    return shape_ == CmaShape::diagonal ? i : 0;
  }

  std::size_t n_;
  CmaShape shape_;
  CmaConstants constants_;
  int generation_ = 0;
  std::vector<double> mean_;        // (n); may lie slightly outside the cube
  double step_;                     // σ
  std::vector<double> covariance_;  // C (n × n), the lower triangle
  std::vector<double> factor_;      // Lᵀ (n × n), the upper triangle, C = L Lᵀ
  std::vector<double> path_sigma_;  // (n) in the coordinates of z
  std::vector<double> path_c_;      // (n)
  std::vector<double> z_;           // (population × n) standard normal
  std::vector<double> y_;           // (population × n) = L z
  std::vector<double> points_;      // (population × n) = mean + σ y, clamped to the cube
  std::vector<double> excess_;  // (population) mean square of the clamped distance, in deviations
  bool heeds_path_ = true;      // the tutorial's h_σ
  bool degenerate_ = false;
};

}  // namespace shigusa
