// SPDX-License-Identifier: MIT
#include "nlp/variable_metric.hpp"

#include <algorithm>
#include <shigusa/math.hpp>

#include "core/check.hpp"
#include "core/index.hpp"

namespace shigusa {
namespace {

// Distance to a limit, as a share of the tolerance, at which it counts as met.
constexpr double kTouch = 1e-3;
// Relative increase of a value that may be due to rounding: then only the slope decides.
constexpr double kValueNoise = 1e-10;
// Square of a unit normal's rest after projection on others below which it depends on them.
constexpr double kDependent = 1e-12;
// Speed towards a limit, as a share of a direction's length, below which it runs along the limit.
constexpr double kGrazing = 1e-12;
// Curvature, as a share of the least one, below which the metric is not updated: it would lose its
// scale.
constexpr double kCurvatureFloor = 1e-2;
// Number of first trials of a line search that follow their secant without bounds.
constexpr int kFreeSecants = 3;
// Largest ratio of a trial to the last one beyond it in a line search.
constexpr double kStretch = 8.0;
// Margin of a bounded trial from both ends of an interval, as a share of it.
constexpr double kSecantMargin = 0.1;

// Bracket of the slope's root along a line.
struct Bracket {
  double low = 0.0;  // the function decreases there
  double low_slope = 0.0;
  double high = -1.0;  // it does not decrease there; -1: unknown
  double high_slope = 0.0;
  double before = 0.0;  // the former of two trials with a decrease
  double before_slope = 0.0;

  void take(double t, double slope, bool falls) {
    if (falls) {
      before = low;
      before_slope = low_slope;
      low = t;
      low_slope = slope;
    } else {
      high = t;
      high_slope = slope;
    }
  }

  // The next trial, by secants; `freely`: without a margin from the bracket's ends.
  [[nodiscard]] double next(bool freely) const {
    if (high < 0.0) {
      const double bend = low_slope - before_slope;
      const double root = bend > 0.0 ? low - low_slope * (low - before) / bend : kStretch * low;
      return clamp(root, 1.1 * low, kStretch * low);
    }
    const double bend = high_slope - low_slope;
    double share = high_slope > 0.0 && bend > 0.0 ? -low_slope / bend : 0.5;
    if (!freely || !(share > 0.0)) share = clamp(share, kSecantMargin, 1.0 - kSecantMargin);
    return low + share * (high - low);
  }
};

double inner(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Computes normal · v.
double across(const LinearLimit& limit, std::span<const double> v) {
  double sum = limit.a * v[index(limit.first)];
  if (limit.b != 0.0) sum += limit.b * v[index(limit.second)];
  return sum;
}

// Computes v += factor · normal.
void add_normal(const LinearLimit& limit, double factor, std::span<double> v) {
  v[index(limit.first)] += factor * limit.a;
  if (limit.b != 0.0) v[index(limit.second)] += factor * limit.b;
}

// Computes normal · normal of two limits.
double product(const LinearLimit& p, const LinearLimit& q) {
  double sum = p.first == q.first ? p.a * q.a : 0.0;
  if (q.b != 0.0 && p.first == q.second) sum += p.a * q.b;
  if (p.b != 0.0 && p.second == q.first) sum += p.b * q.a;
  if (p.b != 0.0 && q.b != 0.0 && p.second == q.second) sum += p.b * q.b;
  return sum;
}

void check(const VariableMetricSettings& settings, std::span<const LinearLimit> limits) {
  SHG_CHECK(settings.tolerance > 0.0, "tolerance of a variable metric");
  SHG_CHECK(settings.max_step > 0.0, "max_step of a variable metric");
  SHG_CHECK(settings.iterations >= 1 && settings.iterations <= 100000,
            "iterations of a variable metric");
  SHG_CHECK(settings.line_slope >= 0.01 && settings.line_slope <= 0.9,
            "line_slope of a variable metric");
  SHG_CHECK(settings.line_evaluations >= 2 && settings.line_evaluations <= 100,
            "line_evaluations of a variable metric");
  for (const LinearLimit& limit : limits) {
    SHG_CHECK(limit.bound >= 0.0, "the origin is inside all limits");
  }
}

}  // namespace

struct VariableMetric::Run {
  SmoothFunction& function;
  std::span<const LinearLimit> limits;
  std::span<const double> size;
  const VariableMetricSettings& settings;
  VariableMetricOutcome outcome{};

  [[nodiscard]] const LinearLimit& limit(int i) const { return limits[index(i)]; }
  double evaluate(std::span<const double> z, std::span<double> gradient) {
    ++outcome.evaluations;
    return function.evaluate(z, gradient);
  }
};

VariableMetric::VariableMetric(int variables) : n_(index(variables)) {
  SHG_CHECK(variables >= 1 && variables <= kMaxMetricVariables, "variables of a variable metric");
  for (std::vector<double>* v : {&z_, &gradient_, &trial_, &trial_gradient_, &direction_, &change_,
                                 &product_, &multipliers_}) {
    v->resize(n_);
  }
  metric_.resize(n_ * n_);
  taken_.resize(n_ * n_);
  active_.reserve(n_);
  kept_.reserve(n_);
  reset();
}

void VariableMetric::reset() {
  active_.clear();
  set_curvature(1.0, {});
}

void VariableMetric::set_curvature(double least, std::span<const double> rows) {
  SHG_CHECK(least > 0.0 && rows.size() % n_ == 0, "curvature of a variable metric");
  std::fill(metric_.begin(), metric_.end(), 0.0);
  for (std::size_t i = 0; i < n_; ++i) metric_[i * n_ + i] = 1.0 / least;
  restricted_ = active_.empty();
  least_ = least;
  // row by row, (H⁻¹ + r rᵀ)⁻¹ = H - H r rᵀ H / (1 + rᵀ H r)
  for (std::size_t row = 0; row < rows.size(); row += n_) {
    const std::span<const double> r = rows.subspan(row, n_);
    multiply_metric(r);
    const double factor = 1.0 / (1.0 + inner(product_, r));
    for (std::size_t i = 0; i < n_; ++i) {
      const double scaled = factor * product_[i];
      for (std::size_t k = 0; k < n_; ++k) metric_[i * n_ + k] -= scaled * product_[k];
    }
  }
}

// Sets product_ to H v.
void VariableMetric::multiply_metric(std::span<const double> v) {
  for (std::size_t i = 0; i < n_; ++i) {
    product_[i] = inner(std::span(metric_).subspan(i * n_, n_), v);
  }
}

// Removes the active limits' normals from an unrestricted metric.
void VariableMetric::restrict_metric(const Run& run) {
  kept_.swap(active_);
  active_.clear();
  for (const int limit : kept_) activate(run, limit);
  restricted_ = true;
}

// Factorises Nᵀ N, with N the normals of the active limits except one.
void VariableMetric::factorize_active(const Run& run, int without) {
  int row = 0;
  for (std::size_t i = 0; i < active_.size(); ++i) {
    if (static_cast<int>(i) == without) continue;
    int column = 0;
    for (std::size_t j = 0; j <= i; ++j) {
      if (static_cast<int>(j) == without) continue;
      gram_(row, column++) = product(run.limit(active_[i]), run.limit(active_[j]));
    }
    ++row;
  }
  ldlt_factorize(gram_, row, kDependent);
}

// Computes v := v - N (Nᵀ N)⁻¹ Nᵀ v after factorize_active; the multipliers are (Nᵀ N)⁻¹ Nᵀ v.
void VariableMetric::project(const Run& run, int without, std::span<double> v) {
  int rows = 0;
  for (std::size_t i = 0; i < active_.size(); ++i) {
    if (static_cast<int>(i) == without) continue;
    multipliers_[index(rows++)] = across(run.limit(active_[i]), v);
  }
  ldlt_substitute(gram_, multipliers_.data(), rows);
  std::size_t row = 0;
  for (std::size_t i = 0; i < active_.size(); ++i) {
    if (static_cast<int>(i) == without) continue;
    add_normal(run.limit(active_[i]), -multipliers_[row++], v);
  }
}

double VariableMetric::largest_part(const Run& run, std::span<const double> step) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < n_; ++i) largest = max(abs(step[i]) * run.size[i], largest);
  return largest;
}

// Length along the direction from z to the nearest limit, and its index, or -1.
double VariableMetric::length_to_limits(const Run& run, int& nearest) const {
  const double least_speed = kGrazing * sqrt(inner(direction_, direction_));
  double length = __builtin_inf();
  nearest = -1;
  for (std::size_t k = 0; k < run.limits.size(); ++k) {
    const LinearLimit& limit = run.limits[k];
    const double speed = across(limit, direction_);
    if (!(speed > least_speed)) continue;
    const int index = static_cast<int>(k);
    if (std::find(active_.begin(), active_.end(), index) != active_.end()) continue;
    const double room = max(limit.bound - across(limit, z_), 0.0);
    if (room < length * speed) {
      length = room / speed;
      nearest = index;
    }
  }
  return length;
}

// Starts at the origin and moves towards the guess, on the active limits if all can be reached.
void VariableMetric::start(Run& run) {
  if (!restricted_) restrict_metric(run);
  factorize_active(run, -1);
  direction_ = z_;
  std::fill(z_.begin(), z_.end(), 0.0);
  project(run, -1, direction_);
  for (std::size_t j = 0; j < active_.size(); ++j) multipliers_[j] = run.limit(active_[j]).bound;
  ldlt_substitute(gram_, multipliers_.data(), static_cast<int>(active_.size()));
  for (std::size_t j = 0; j < active_.size(); ++j) {
    add_normal(run.limit(active_[j]), multipliers_[j], direction_);
  }
  int nearest = -1;
  const double length = min(1.0, length_to_limits(run, nearest));
  if (length < 1.0) release_all();
  for (std::size_t i = 0; i < n_; ++i) z_[i] = length * direction_[i];
  run.outcome.value = run.evaluate(z_, gradient_);
}

// Restores the parts of the metric removed by the active limits, the last first.
void VariableMetric::release_all() {
  for (std::size_t j = active_.size(); j-- > 0;) {
    const std::span<const double> v = std::span(taken_).subspan(j * n_, n_);
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < n_; ++k) metric_[i * n_ + k] += v[i] * v[k];
    }
  }
  active_.clear();
}

void VariableMetric::find_direction(const Run& run) {
  for (std::size_t i = 0; i < n_; ++i) {
    direction_[i] = -inner(std::span(metric_).subspan(i * n_, n_), gradient_);
  }
  if (active_.empty()) return;
  // H a = 0 except for rounding, which accumulates
  factorize_active(run, -1);
  project(run, -1, direction_);
}

// Drops the active limit that promises the most, if that is more than `gain_of_staying`.
bool VariableMetric::drop_limit(const Run& run, double gain_of_staying) {
  double most = gain_of_staying;
  int dropped = -1;
  for (std::size_t j = 0; j < active_.size(); ++j) {
    product_.assign(taken_.begin() + static_cast<std::ptrdiff_t>(j * n_),
                    taken_.begin() + static_cast<std::ptrdiff_t>((j + 1) * n_));
    const int index = static_cast<int>(j);
    if (active_.size() > 1) {
      factorize_active(run, index);
      project(run, index, product_);
    }
    const double slope = inner(product_, gradient_);
    // whether it would be left to the inside
    if (!(slope * across(run.limit(active_[j]), product_) > 0.0)) continue;
    if (!(slope * slope > most)) continue;
    if (largest_part(run, product_) * abs(slope) <= run.settings.tolerance) continue;
    most = slope * slope;
    dropped = index;
    change_ = product_;
  }
  if (dropped < 0) return false;
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t k = 0; k < n_; ++k) metric_[i * n_ + k] += change_[i] * change_[k];
  }
  const auto row = static_cast<std::ptrdiff_t>(dropped) * static_cast<std::ptrdiff_t>(n_);
  std::move(taken_.begin() + row + static_cast<std::ptrdiff_t>(n_),
            taken_.begin() + static_cast<std::ptrdiff_t>(active_.size() * n_),
            taken_.begin() + row);
  active_.erase(active_.begin() + dropped);
  return true;
}

void VariableMetric::activate(const Run& run, int limit) {
  if (active_.size() == n_) return;
  std::fill(change_.begin(), change_.end(), 0.0);
  add_normal(run.limit(limit), 1.0, change_);
  multiply_metric(change_);
  const double square = inner(product_, change_);
  if (!(square > 0.0)) return;
  const double scale = 1.0 / sqrt(square);
  for (double& part : product_) part = part * scale;
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t k = 0; k < n_; ++k) metric_[i * n_ + k] -= product_[i] * product_[k];
  }
  std::copy(product_.begin(), product_.end(),
            taken_.begin() + static_cast<std::ptrdiff_t>(active_.size() * n_));
  active_.push_back(limit);
}

// Sets the trial to a point along the direction, at most `most` times its length away, where the
// slope has fallen and the value is no larger. Returns the multiple; 0 if there is no such point.
double VariableMetric::search_line(Run& run, double most) {
  const double slope0 = inner(direction_, gradient_);
  const double ceiling = run.outcome.value + kValueNoise * abs(run.outcome.value);
  Bracket bracket{.low_slope = slope0};
  double t = min(1.0, most);
  for (int k = 0; k < run.settings.line_evaluations; ++k) {
    const double value = try_at(run, t);
    const double slope = inner(direction_, trial_gradient_);
    const bool lower = value <= ceiling;
    const bool flat = abs(slope) <= -run.settings.line_slope * slope0;
    if (lower && (flat || (slope < 0.0 && t == most))) {
      run.outcome.value = value;
      return t;
    }
    bracket.take(t, slope, lower && slope < 0.0);
    t = min(bracket.next(k < kFreeSecants), most);
  }
  if (bracket.low > 0.0) run.outcome.value = try_at(run, bracket.low);
  return bracket.low;
}

double VariableMetric::try_at(Run& run, double t) {
  for (std::size_t i = 0; i < n_; ++i) trial_[i] = z_[i] + t * direction_[i];
  return run.evaluate(trial_, trial_gradient_);
}

// BFGS update, from z and its gradient to the trial's.
void VariableMetric::update_metric() {
  for (std::size_t i = 0; i < n_; ++i) {
    direction_[i] = trial_[i] - z_[i];
    change_[i] = trial_gradient_[i] - gradient_[i];
  }
  const double curvature = inner(direction_, change_);
  if (!(curvature > kCurvatureFloor * least_ * inner(direction_, direction_))) return;
  multiply_metric(change_);
  const double inverse = 1.0 / curvature;
  const double factor = 0.5 * (1.0 + inner(change_, product_) * inverse) * inverse;
  // H += s uᵀ + u sᵀ
  for (std::size_t i = 0; i < n_; ++i) {
    product_[i] = factor * direction_[i] - inverse * product_[i];
  }
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t k = 0; k < n_; ++k) {
      metric_[i * n_ + k] += direction_[i] * product_[k] + product_[i] * direction_[k];
    }
  }
}

VariableMetricOutcome VariableMetric::minimise(SmoothFunction& function,
                                               std::span<const LinearLimit> limits,
                                               std::span<const double> size,
                                               const VariableMetricSettings& settings,
                                               std::span<double> z) {
  check(settings, limits);
  SHG_CHECK(z.size() == n_ && size.size() == n_, "variables of a variable metric");
  Run run{function, limits, size, settings};
  std::copy(z.begin(), z.end(), z_.begin());
  start(run);
  VariableMetricOutcome& outcome = run.outcome;
  for (; outcome.iterations < settings.iterations; ++outcome.iterations) {
    find_direction(run);
    const double gain = -inner(direction_, gradient_);
    if (!is_finite(gain)) break;
    const double step = largest_part(run, direction_);
    const bool arrived = step <= settings.tolerance;
    if (drop_limit(run, arrived ? 0.0 : gain)) continue;
    if (arrived) {
      outcome.converged = true;
      break;
    }
    int nearest = -1;
    const double length = length_to_limits(run, nearest);
    if (length * step <= kTouch * settings.tolerance) {
      activate(run, nearest);
      continue;
    }
    const double most = min(length, settings.max_step / step);
    const double taken = search_line(run, most);
    if (taken == 0.0) break;
    update_metric();
    z_.swap(trial_);
    gradient_.swap(trial_gradient_);
    if (taken == length) activate(run, nearest);
  }
  std::copy(z_.begin(), z_.end(), z.begin());
  return outcome;
}

}  // namespace shigusa
