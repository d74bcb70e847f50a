// SPDX-License-Identifier: MIT
#include "cma_run.hpp"

#include <algorithm>
#include <shigusa/math.hpp>
#include <utility>

#include "normal.hpp"
#include "population.hpp"
#include "scorer.hpp"

namespace shigusa {
namespace {

// Ratio in a factor's diagonal beyond which half of the digits are lost: a condition of 1e14.
constexpr double kFactorRange = 1e-7;

// Best value between 0.1 and 3 for functions with an optimum on the cube's faces.
constexpr double kBoundPenalty = 0.5;

// Factor on the rates of a diagonal.
double diagonal_haste(double genes) { return 2.0 * (genes + 2.0) / 3.0; }

}  // namespace

CmaConstants::CmaConstants(int genes, int population, CmaShape shape) {
  const double n = genes;
  const int mu = population / 2;
  double sum[2] = {0.0, 0.0};      // of the positive weights, of the absolute negative ones
  double squares[2] = {0.0, 0.0};  // of the same
  for (int i = 1; i <= population; ++i) {
    const double weight = natural_log(0.5 * (population + 1)) - natural_log(i);
    const int part = i <= mu ? 0 : 1;
    sum[part] += abs(weight);
    squares[part] += weight * weight;
    weights.push_back(weight);
  }
  mu_eff = sum[0] * sum[0] / squares[0];
  const double mu_eff_negative = sum[1] * sum[1] / squares[1];
  const double haste = shape == CmaShape::diagonal ? diagonal_haste(n) : 1.0;
  c_one = min(0.5, haste * 2.0 / ((n + 1.3) * (n + 1.3) + mu_eff));
  c_mu = min(1.0 - c_one,
             haste * 2.0 * (0.25 + mu_eff + 1.0 / mu_eff - 2.0) / ((n + 2.0) * (n + 2.0) + mu_eff));
  c_path = (4.0 + mu_eff / n) / (n + 4.0 + 2.0 * mu_eff / n);
  c_sigma = (mu_eff + 2.0) / (n + mu_eff + 5.0);
  d_sigma = 1.0 + 2.0 * max(0.0, sqrt((mu_eff - 1.0) / (n + 1.0)) - 1.0) + c_sigma;
  expected_norm = sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
  const double negative_sum =
      min(min(1.0 + c_one / c_mu, 1.0 + 2.0 * mu_eff_negative / (mu_eff + 2.0)),
          (1.0 - c_one - c_mu) / (n * c_mu));
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] *= i < static_cast<std::size_t>(mu) ? 1.0 / sum[0] : negative_sum / sum[1];
  }
}

CmaRun::CmaRun(std::vector<double> mean, double step, int population, CmaShape shape)
    : n_(mean.size()),
      shape_(shape),
      constants_(static_cast<int>(mean.size()), population, shape),
      mean_(std::move(mean)),
      step_(step),
      covariance_(n_ * n_, 0.0),
      path_sigma_(n_, 0.0),
      path_c_(n_, 0.0),
      z_(n_ * static_cast<std::size_t>(population)),
      y_(z_.size()),
      points_(z_.size()),
      excess_(static_cast<std::size_t>(population)) {
  for (std::size_t i = 0; i < n_; ++i) covariance_[i * n_ + i] = 1.0;
  factor_ = covariance_;
}

void CmaRun::scale(std::span<const double> scales) {
  for (std::size_t i = 0; i < n_; ++i) {
    covariance_[i * n_ + i] = scales[i] * scales[i];
    factor_[i * n_ + i] = scales[i];
  }
}

void CmaRun::learn_whole() {
  if (shape_ == CmaShape::whole) return;
  shape_ = CmaShape::whole;
  constants_ = CmaConstants(static_cast<int>(n_), population(), shape_);
}

const std::vector<double>& CmaRun::sample(Random& random, bool mirrored) {
  const std::size_t drawn = mirrored ? (excess_.size() + 1) / 2 : excess_.size();
  for (std::size_t p = 0; p < excess_.size(); ++p) {
    double* z = &z_[p * n_];
    double* y = &y_[p * n_];
    double* x = &points_[p * n_];
    for (std::size_t i = 0; i < n_; ++i)
      z[i] = p < drawn ? normal(random) : -z_[(p - drawn) * n_ + i];
    std::fill_n(y, n_, 0.0);
    for (std::size_t j = 0; j < n_; ++j) {
      // a column of L is stored as a row: the additions are independent of one another
      const double* column = &factor_[j * n_];
      const std::size_t end = shape_ == CmaShape::diagonal ? j + 1 : n_;
      for (std::size_t i = j; i < end; ++i) y[i] += column[i] * z[j];
    }
    excess_[p] = 0.0;
    for (std::size_t i = 0; i < n_; ++i) {
      const double wanted = mean_[i] + step_ * y[i];
      x[i] = clamp(wanted, 0.0, 1.0);
      if (wanted == x[i]) continue;
      const double beyond = (wanted - x[i]) / (step_ * sqrt(covariance_[i * n_ + i]));
      excess_[p] += beyond * beyond / static_cast<double>(n_);
    }
  }
  return points_;
}

void CmaRun::put_mean_first() {
  set_point(points_, 0, mean_);
  std::fill_n(y_.begin(), n_, 0.0);
  std::fill_n(z_.begin(), n_, 0.0);
  excess_[0] = 0.0;
}

// Scores plus a penalty for the distance beyond the cube, which keeps the mean near it: the
// interquartile range of the scores, times kBoundPenalty, for one standard deviation in each
// coordinate.
std::vector<double> CmaRun::penalised(std::span<const double> scores) const {
  const std::vector<std::size_t> order = ranked(scores);
  const double spread = scores[order[order.size() * 3 / 4]] - scores[order[order.size() / 4]];
  std::vector<double> result(scores.begin(), scores.end());
  if (!is_finite(spread)) return result;
  for (std::size_t p = 0; p < result.size(); ++p) {
    result[p] += kBoundPenalty * spread * excess_[p];
  }
  return result;
}

void CmaRun::update(std::span<const double> scores) {
  const std::vector<std::size_t> order = ranked(penalised(scores));
  ++generation_;
  move_mean(order);
  adapt_covariance(order);
  adapt_step();
  factorise();
}

void CmaRun::move_mean(std::span<const std::size_t> order) {
  std::vector<double> z_mean(n_, 0.0);
  std::vector<double> y_mean(n_, 0.0);
  for (std::size_t k = 0; k < order.size() / 2; ++k) {
    for (std::size_t i = 0; i < n_; ++i) {
      z_mean[i] += constants_.weights[k] * z_[order[k] * n_ + i];
      y_mean[i] += constants_.weights[k] * y_[order[k] * n_ + i];
    }
  }
  const CmaConstants& c = constants_;
  double squares = 0.0;
  for (std::size_t i = 0; i < n_; ++i) {
    mean_[i] += step_ * y_mean[i];
    path_sigma_[i] = (1.0 - c.c_sigma) * path_sigma_[i] +
                     sqrt(c.c_sigma * (2.0 - c.c_sigma) * c.mu_eff) * z_mean[i];
    squares += path_sigma_[i] * path_sigma_[i];
  }
  double decay = 1.0;  // (1 - c_sigma)^(2 generations); soon negligible
  for (int g = 0; g < 2 * generation_ && decay > 1e-9; ++g) decay *= 1.0 - c.c_sigma;
  const double limit = (1.4 + 2.0 / (static_cast<double>(n_) + 1.0)) * c.expected_norm;
  heeds_path_ = squares < limit * limit * (1.0 - decay);
  for (std::size_t i = 0; i < n_; ++i) {
    path_c_[i] *= 1.0 - c.c_path;
    if (heeds_path_) path_c_[i] += sqrt(c.c_path * (2.0 - c.c_path) * c.mu_eff) * y_mean[i];
  }
}

void CmaRun::adapt_covariance(std::span<const std::size_t> order) {
  const CmaConstants& c = constants_;
  const double n = static_cast<double>(n_);
  std::vector<double> weights = c.weights;
  double weight_sum = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    weight_sum += weights[k];
    if (weights[k] >= 0.0) continue;
    // the effect of a bad point must not depend on its distance
    double squares = 0.0;
    for (std::size_t i = 0; i < n_; ++i) squares += z_[order[k] * n_ + i] * z_[order[k] * n_ + i];
    weights[k] *= n / max(squares, 1e-12);
  }
  const double kept_path = heeds_path_ ? 0.0 : c.c_path * (2.0 - c.c_path);
  const double keep = 1.0 + c.c_one * kept_path - c.c_one - c.c_mu * weight_sum;
  for (std::size_t i = 0; i < n_; ++i) {
    double* row = &covariance_[i * n_];
    for (std::size_t j = first_column(i); j <= i; ++j) {
      row[j] = keep * row[j] + c.c_one * path_c_[i] * path_c_[j];
    }
  }
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double* y = &y_[order[k] * n_];
    for (std::size_t i = 0; i < n_; ++i) {
      const double scaled = c.c_mu * weights[k] * y[i];
      double* row = &covariance_[i * n_];
      for (std::size_t j = first_column(i); j <= i; ++j) row[j] += scaled * y[j];
    }
  }
}

void CmaRun::adapt_step() {
  double squares = 0.0;
  for (const double p : path_sigma_) squares += p * p;
  const double longer = sqrt(squares) / constants_.expected_norm - 1.0;
  step_ *= exponential(min(1.0, constants_.c_sigma / constants_.d_sigma * longer));
  // the step is limited to the size of the cube
  step_ = min(step_, 1.0);
}

void CmaRun::factorise() {
  double least = kWorst;
  double most = 0.0;
  // column by column; the contributions of earlier columns are subtracted at once
  for (std::size_t j = 0; j < n_; ++j) {
    for (std::size_t i = j; i < n_; ++i) factor_[j * n_ + i] = covariance_[i * n_ + j];
  }
  for (std::size_t j = 0; j < n_; ++j) {
    double* column = &factor_[j * n_];
    if (!(column[j] > 0.0) || !is_finite(column[j])) {
      degenerate_ = true;
      return;
    }
    const double diagonal = sqrt(column[j]);
    const std::size_t end = shape_ == CmaShape::diagonal ? j + 1 : n_;
    for (std::size_t i = j; i < end; ++i) column[i] /= diagonal;
    for (std::size_t k = j + 1; k < end; ++k) {
      double* later = &factor_[k * n_];
      for (std::size_t i = k; i < n_; ++i) later[i] -= column[k] * column[i];
    }
    least = min(least, diagonal);
    most = max(most, diagonal);
  }
  degenerate_ = least < kFactorRange * most || !is_finite(step_) || step_ <= 0.0;
}

double CmaRun::spread() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < n_; ++i) largest = max(largest, covariance_[i * n_ + i]);
  return step_ * sqrt(largest);
}

}  // namespace shigusa
