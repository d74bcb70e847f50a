// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "math/ldlt.hpp"

namespace shigusa {

// A function of n variables with its gradient.
class SmoothFunction {
 public:
  virtual ~SmoothFunction() = default;
  // The value at z (n); writes the gradient (n).
  virtual double evaluate(std::span<const double> z, std::span<double> gradient) = 0;
};

// A half space of one variable or two: a z[first] + b z[second] ≤ bound, with a² + b² = 1.
struct LinearLimit {
  int first = 0;
  int second = 0;  // used if b is not 0
  double a = 1.0;
  double b = 0.0;
  double bound = 0.0;  // ≥ 0: the origin is inside
};

struct VariableMetricSettings {
  double tolerance = 1e-7;  // largest component of a step below which the search has converged, > 0
  double max_step = 0.25;   // largest change of a variable in one iteration, > 0
  int iterations = 200;     // at most, 1..100000
  double line_slope = 0.2;  // share of the slope at which a line search ends, 0.01..0.9
  int line_evaluations = 20;  // of one line search at most, 2..100
};

struct VariableMetricOutcome {
  double value = 0.0;      // of the function at the end
  bool converged = false;  // false: the iterations ran out, or rounding allowed no more descent
  int iterations = 0;
  int evaluations = 0;
};

inline constexpr int kMaxMetricVariables = 64;

// Minimises a smooth function of n variables over linear inequalities by a variable metric method
// with an active set:
//
//   z := the origin, moved towards the guess on the active limits as far as all others allow;
//     if that is not as far as the guess, no limit stays active
//   until the step s = -H g is small and no active limit is worth dropping:
//     if leaving an active limit promises more than staying: drop it, H := H + v vᵀ
//     else search along s, up to the nearest limit, until the slope has fallen:
//       H := BFGS update of H by the step and the gradient's change
//       at a limit a: make it active, v := H a / √(aᵀ H a), H := H - v vᵀ, so that H a = 0
//
// H is the inverse of the Hessian on the active limits' common face, and 0 across. The v that a
// limit removes is kept and restored, orthogonal to the other active limits, when it is dropped:
// without changes in between, H would be as before. H and the active set persist to the next call,
// which should be about a similar function under the same limits with other bounds. If the function
// is nearly quadratic and its curvature given, one or two iterations are enough.
//
// Source: D. Goldfarb, SIAM J. Applied Mathematics 17 (1969) 739-764, for the projected metric and
// the dropping of limits, after J. Rosen's gradient projection, J. SIAM 8 (1960) 181-217; the
// update of Broyden, Fletcher, Goldfarb and Shanno (1970). J. Zhao and N. Badler, ACM Trans.
// Graphics 13 (1994) 313-336, use it for inverse kinematics. Left out: the search for a feasible
// point, since the origin is one. There the rank-one term of a dropped limit is a multiple of its
// projected normal; here it is the removed v, which has the right scale.
//
// Plain loops in a fixed order over + - * / and sqrt: the same bytes everywhere.
class VariableMetric {
 public:
  // Makes a minimiser of 1..kMaxMetricVariables variables.
  explicit VariableMetric(int variables);

  // Resets H to the identity, with no active limit.
  void reset();

  // Sets the known curvature of the function: H becomes the inverse of `least` (> 0) times the
  // identity plus Σ r rᵀ over the rows r, (rows × n). Active limits stay active.
  void set_curvature(double least, std::span<const double> rows);

  // Minimises the function; `z` (n) holds a guess and then the result. `size` (n, ≥ 0): size of a
  // unit change of each variable in the settings' tolerance and max_step. Settings outside their
  // ranges and limits with a negative bound throw PreconditionError. A gradient that is not finite
  // ends the search at the last point.
  VariableMetricOutcome minimise(SmoothFunction& function, std::span<const LinearLimit> limits,
                                 std::span<const double> size,
                                 const VariableMetricSettings& settings, std::span<double> z);

  // Indices of the active limits, in the order in which they were met.
  [[nodiscard]] std::span<const int> active() const { return active_; }

 private:
  struct Run;  // data of one call

  void start(Run& run);
  void restrict_metric(const Run& run);
  void release_all();
  void multiply_metric(std::span<const double> v);
  void find_direction(const Run& run);
  [[nodiscard]] bool drop_limit(const Run& run, double gain_of_staying);
  [[nodiscard]] double largest_part(const Run& run, std::span<const double> step) const;
  [[nodiscard]] double length_to_limits(const Run& run, int& nearest) const;
  [[nodiscard]] double search_line(Run& run, double most);
  double try_at(Run& run, double t);
  void update_metric();
  void activate(const Run& run, int limit);
  void factorize_active(const Run& run, int without);
  void project(const Run& run, int without, std::span<double> v);

  std::size_t n_;
  std::vector<double> metric_;          // (n × n) H
  bool restricted_ = true;              // whether H is 0 across the active limits
  double least_ = 1.0;                  // least known curvature of the function
  std::vector<double> z_;               // (n)
  std::vector<double> gradient_;        // (n) at z
  std::vector<double> trial_;           // (n) along the line
  std::vector<double> trial_gradient_;  // (n)
  std::vector<double> direction_;       // (n) s
  std::vector<double> change_;          // (n) scratch: change of the gradient
  std::vector<double> product_;         // (n) scratch
  std::vector<int> active_;             // at most n
  std::vector<int> kept_;               // scratch: copy of active_
  std::vector<double> taken_;           // (n × n) v of each active limit, row by row
  SmallSymmetric<double, kMaxMetricVariables> gram_;
  std::vector<double> multipliers_;  // (n)
};

}  // namespace shigusa
