// SPDX-License-Identifier: MIT
#include "nlp/variable_metric.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <shigusa/run.hpp>

#include "core/check.hpp"

namespace shigusa {
namespace {

using Vector = std::vector<double>;
using Limits = std::vector<LinearLimit>;

class Function : public SmoothFunction {
 public:
  using Evaluate = std::function<double(std::span<const double>, std::span<double>)>;
  explicit Function(Evaluate evaluate) : evaluate_(std::move(evaluate)) {}
  double evaluate(std::span<const double> z, std::span<double> gradient) override {
    return evaluate_(z, gradient);
  }

 private:
  Evaluate evaluate_;
};

// ½ Σ c_i (z_i - middle_i)²
Function bowl(const Vector& curvature, const Vector& middle) {
  return Function([=](std::span<const double> z, std::span<double> gradient) {
    double value = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      gradient[i] = curvature[i] * (z[i] - middle[i]);
      value += 0.5 * gradient[i] * (z[i] - middle[i]);
    }
    return value;
  });
}

// H. Rosenbrock, The Computer Journal 3 (1960): 0 at (1, 1), seen from its usual start (-1.2, 1)
constexpr double kStartX = -1.2;
constexpr double kStartY = 1.0;
Function rosenbrock() {
  return Function([](std::span<const double> z, std::span<double> gradient) {
    const double x = z[0] + kStartX;
    const double y = z[1] + kStartY;
    const double off = y - x * x;
    gradient[0] = -400.0 * x * off - 2.0 * (1.0 - x);
    gradient[1] = 200.0 * off;
    return 100.0 * off * off + (1.0 - x) * (1.0 - x);
  });
}

constexpr VariableMetricSettings kFine{.tolerance = 1e-9, .max_step = 10.0, .iterations = 500};

struct Minimum {
  VariableMetricOutcome outcome;
  Vector z;
};

Minimum minimise(SmoothFunction& function, const Limits& limits, Vector guess,
                 VariableMetric& metric, const VariableMetricSettings& settings = kFine) {
  const Vector size(guess.size(), 1.0);
  Minimum result{{}, std::move(guess)};
  result.outcome = metric.minimise(function, limits, size, settings, result.z);
  return result;
}

TEST(VariableMetric, FindsRosenbrocksMinimum) {
  Function function = rosenbrock();
  VariableMetric metric(2);
  const Minimum found = minimise(function, {}, {0, 0}, metric);
  EXPECT_TRUE(found.outcome.converged);
  EXPECT_NEAR(found.z[0] + kStartX, 1.0, 1e-8);
  EXPECT_NEAR(found.z[1] + kStartY, 1.0, 1e-8);
  // steepest descent would take thousands
  EXPECT_LE(found.outcome.iterations, 60);
}

TEST(VariableMetric, FindsRosenbrocksMinimumOnAnUpperLimit) {
  // with x ≤ 1/2 the best is y = x² there
  Function function = rosenbrock();
  VariableMetric metric(2);
  const Limits limits{{.first = 0, .bound = 0.5 - kStartX}};
  const Minimum found = minimise(function, limits, {0, 0}, metric);
  EXPECT_TRUE(found.outcome.converged);
  EXPECT_NEAR(found.z[0] + kStartX, 0.5, 1e-12);
  EXPECT_NEAR(found.z[1] + kStartY, 0.25, 1e-8);
  EXPECT_EQ(metric.active().size(), 1u);
}

TEST(VariableMetric, GivenTheCurvatureOneStepIsEnough) {
  Function function = bowl({1e-4, 3.0, 700.0}, {0.3, -0.2, 0.1});
  VariableMetric metric(3);
  Vector rows{0, std::sqrt(3.0 - 1e-4), 0, 0, 0, std::sqrt(700.0 - 1e-4)};
  metric.set_curvature(1e-4, rows);
  const Minimum found = minimise(function, {}, {0, 0, 0}, metric);
  EXPECT_TRUE(found.outcome.converged);
  EXPECT_EQ(found.outcome.evaluations, 2);
  EXPECT_NEAR(found.z[0], 0.3, 1e-10);
  EXPECT_NEAR(found.z[1], -0.2, 1e-10);
  EXPECT_NEAR(found.z[2], 0.1, 1e-10);
}

TEST(VariableMetric, WithoutTheCurvatureItLearnsThatOfAQuadratic) {
  // one iteration for each different curvature, and exact line searches are only approached
  Function function = bowl({1e-2, 1e-2, 1.0, 50.0}, {0.3, -0.2, 0.1, 1.0});
  VariableMetric metric(4);
  metric.set_curvature(1e-2, {});
  const Minimum found = minimise(function, {}, {0, 0, 0, 0}, metric);
  EXPECT_TRUE(found.outcome.converged);
  EXPECT_LE(found.outcome.iterations, 12);
  EXPECT_NEAR(found.z[0], 0.3, 1e-7);
  EXPECT_NEAR(found.z[3], 1.0, 1e-7);
}

TEST(VariableMetric, LeavesALimitThatTheNextFunctionDoesNotPressAgainst) {
  VariableMetric metric(2);
  const Limits limits{{.first = 0, .bound = 0.5}};
  Function against = bowl({1.0, 1.0}, {2.0, 0.3});
  EXPECT_NEAR(minimise(against, limits, {0, 0}, metric).z[0], 0.5, 1e-15);
  ASSERT_EQ(metric.active().size(), 1u);
  Function away = bowl({1.0, 1.0}, {0.2, 0.3});
  const Minimum found = minimise(away, limits, {0.5, 0.3}, metric);
  EXPECT_TRUE(found.outcome.converged);
  EXPECT_NEAR(found.z[0], 0.2, 1e-9);
  EXPECT_TRUE(metric.active().empty());
}

TEST(VariableMetric, StaysOnAnActiveLimitThatHasMoved) {
  VariableMetric metric(2);
  Function function = bowl({1.0, 1.0}, {2.0, 0.3});
  (void)minimise(function, {{.first = 0, .bound = 0.5}}, {0, 0}, metric);
  const Minimum found = minimise(function, {{.first = 0, .bound = 0.7}}, {0.5, 0.3}, metric);
  EXPECT_TRUE(found.outcome.converged);
  EXPECT_NEAR(found.z[0], 0.7, 1e-15);
  EXPECT_NEAR(found.z[1], 0.3, 1e-9);
}

TEST(VariableMetric, GetsOutOfACornerOfMoreLimitsThanVariables) {
  // all three pass through the origin, and the way down is along the third
  const double half = std::sqrt(0.5);
  const Limits limits{{.first = 0}, {.first = 1}, {.first = 0, .second = 1, .a = half, .b = half}};
  Function function = bowl({1.0, 1.0}, {-3.0, 1.0});
  VariableMetric metric(2);
  const Minimum found = minimise(function, limits, {0, 0}, metric);
  EXPECT_TRUE(found.outcome.converged);
  EXPECT_NEAR(found.z[0], -3.0, 1e-8);
  EXPECT_NEAR(found.z[1], 0.0, 1e-8);
}

TEST(VariableMetric, NoVariableChangesByMoreThanTheLargestStep) {
  Function function = bowl({1.0, 1.0}, {5.0, 1.0});
  VariableMetric metric(2);
  const VariableMetricSettings once{.max_step = 0.25, .iterations = 1};
  const Minimum found = minimise(function, {}, {0, 0}, metric, once);
  EXPECT_FALSE(found.outcome.converged);
  EXPECT_NEAR(found.z[0], 0.25, 1e-15);
  EXPECT_NEAR(found.z[1], 0.05, 1e-15);
}

TEST(VariableMetric, StopsWhereTheGradientIsNotFinite) {
  Function function([](std::span<const double>, std::span<double> gradient) {
    gradient[0] = gradient[1] = std::numeric_limits<double>::quiet_NaN();
    return 0.0;
  });
  VariableMetric metric(2);
  const Minimum found = minimise(function, {}, {0.5, 0.25}, metric);
  EXPECT_FALSE(found.outcome.converged);
  EXPECT_EQ(found.z, (Vector{0.5, 0.25}));
}

TEST(VariableMetric, RefusesWhatIsOutsideItsRanges) {
  Function function = bowl({1.0}, {1.0});
  VariableMetric metric(1);
  EXPECT_THROW(VariableMetric{0}, PreconditionError);
  EXPECT_THROW(VariableMetric{kMaxMetricVariables + 1}, PreconditionError);
  EXPECT_THROW(metric.set_curvature(0.0, {}), PreconditionError);
  EXPECT_THROW(minimise(function, {{.bound = -1e-9}}, {0}, metric), PreconditionError);
  EXPECT_THROW(minimise(function, {}, {0, 0}, metric), PreconditionError);
  const auto refuses = [&](auto change) {
    VariableMetricSettings settings = kFine;
    change(settings);
    EXPECT_THROW(minimise(function, {}, {0}, metric, settings), PreconditionError);
  };
  refuses([](auto& s) { s.tolerance = 0.0; });
  refuses([](auto& s) { s.max_step = 0.0; });
  refuses([](auto& s) { s.iterations = 0; });
  refuses([](auto& s) { s.line_slope = 1.0; });
  refuses([](auto& s) { s.line_evaluations = 1; });
}

// A convex quadratic ½ |R z - b|² + ½ c |z|² with random limits around the origin.
struct RandomQuadratic {
  std::size_t n;
  std::vector<Vector> rows;
  Vector b;
  double c;
  Limits limits;

  explicit RandomQuadratic(std::uint64_t seed) {
    Random random(seed);
    n = 2 + random.below(7);
    c = std::pow(10.0, random.uniform(-3.0, 0.0));
    const std::size_t count = 1 + random.below(4);
    for (std::size_t r = 0; r < count; ++r) {
      Vector row(n);
      for (double& entry : row) entry = random.uniform(-1.0, 1.0);
      rows.push_back(row);
      b.push_back(random.uniform(-2.0, 2.0));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const int k = static_cast<int>(i);
      limits.push_back({.first = k, .bound = random.uniform(0.0, 0.7)});
      limits.push_back({.first = k, .a = -1.0, .bound = random.uniform(0.0, 0.7)});
    }
    const double turn = random.uniform(0.1, 1.4);
    limits.push_back({.first = 0,
                      .second = 1,
                      .a = std::cos(turn),
                      .b = -std::sin(turn),
                      .bound = random.uniform(0.0, 0.5)});
  }

  [[nodiscard]] double operator()(std::span<const double> z, std::span<double> gradient) const {
    double value = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      gradient[i] = c * z[i];
      value += 0.5 * c * z[i] * z[i];
    }
    for (std::size_t r = 0; r < rows.size(); ++r) {
      double off = -b[r];
      for (std::size_t i = 0; i < n; ++i) off += rows[r][i] * z[i];
      value += 0.5 * off * off;
      for (std::size_t i = 0; i < n; ++i) gradient[i] += rows[r][i] * off;
    }
    return value;
  }
};

double along(const LinearLimit& limit, const Vector& z) {
  return limit.a * z[static_cast<std::size_t>(limit.first)] +
         (limit.b == 0.0 ? 0.0 : limit.b * z[static_cast<std::size_t>(limit.second)]);
}

RC_GTEST_PROP(VariableMetricProperty, NoFeasiblePointOfAConvexQuadraticIsLower,
              (std::uint64_t seed, bool informed)) {
  const RandomQuadratic quadratic(seed);
  Function function(
      [&](std::span<const double> z, std::span<double> g) { return quadratic(z, g); });
  VariableMetric metric(static_cast<int>(quadratic.n));
  Vector rows;
  for (const Vector& row : quadratic.rows) rows.insert(rows.end(), row.begin(), row.end());
  metric.set_curvature(quadratic.c, informed ? rows : Vector{});
  const Minimum found = minimise(function, quadratic.limits, Vector(quadratic.n), metric);
  RC_ASSERT(found.outcome.converged);
  for (const LinearLimit& limit : quadratic.limits) {
    RC_ASSERT(along(limit, found.z) <= limit.bound + 1e-12);
  }
  Vector gradient(quadratic.n);
  const double value = quadratic(found.z, gradient);
  Random random(seed, 1);
  for (int k = 0; k < 300; ++k) {
    // halfway to a random corner of the box, and nearer and nearer to z
    Vector other = found.z;
    const double share = std::pow(2.0, -static_cast<double>(random.below(16)));
    for (std::size_t i = 0; i < quadratic.n; ++i) {
      const bool up = random.chance(0.5);
      const LinearLimit& bound = quadratic.limits[2 * i + (up ? 0 : 1)];
      if (random.chance(0.5)) other[i] += share * (bound.a * bound.bound - other[i]);
    }
    const bool inside =
        std::all_of(quadratic.limits.begin(), quadratic.limits.end(),
                    [&](const LinearLimit& limit) { return along(limit, other) <= limit.bound; });
    // the possible gain of a step of kFine.tolerance
    if (inside) RC_ASSERT(quadratic(other, gradient) >= value - 1e-8);
  }
}

RC_GTEST_PROP(VariableMetricProperty, ForgettingAllGivesTheSameBytesAgain, (std::uint64_t seed)) {
  const RandomQuadratic quadratic(seed);
  Function function(
      [&](std::span<const double> z, std::span<double> g) { return quadratic(z, g); });
  VariableMetric metric(static_cast<int>(quadratic.n));
  const Minimum first = minimise(function, quadratic.limits, Vector(quadratic.n), metric);
  metric.reset();
  const Minimum again = minimise(function, quadratic.limits, Vector(quadratic.n), metric);
  RC_ASSERT(first.z == again.z);
  RC_ASSERT(first.outcome.evaluations == again.outcome.evaluations);
}

}  // namespace
}  // namespace shigusa
