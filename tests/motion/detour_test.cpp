// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "motion/minimum_jerk.hpp"

namespace shigusa {
namespace {

// Third derivative by a central difference of step h.
double jerk(double t, double peak) {
  constexpr double h = 1e-3;
  const auto b = [&](double x) { return minimum_jerk_detour(x, peak); };
  return (b(t + 2 * h) - 2 * b(t + h) + 2 * b(t - h) - b(t - 2 * h)) / (2 * h * h * h);
}

double jerk_cost(double peak, double mixed_in) {
  // sin⁴ vanishes with three derivatives at 0 and 1 as the detour does; taken away at the peak
  constexpr int kSteps = 2000;
  constexpr double h = 1e-3;
  const auto other = [&](double t) {
    const auto s4 = [](double x) { return std::pow(std::sin(kPi * x), 4); };
    const double bend = s4(t) - s4(peak) * minimum_jerk_detour(t, peak);
    return minimum_jerk_detour(t, peak) + mixed_in * bend;
  };
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = 2 * h + (1.0 - 4 * h) * (i + 0.5) / kSteps;
    const double j = (other(t + 2 * h) - 2 * other(t + h) + 2 * other(t - h) - other(t - 2 * h)) /
                     (2 * h * h * h);
    sum += j * j / kSteps;
  }
  return sum;
}

TEST(MinimumJerkDetour, IsOneAtItsPeak) {
  for (double peak = 0.02; peak < 1.0; peak += 0.02) {
    EXPECT_NEAR(minimum_jerk_detour(peak, peak), 1.0, 1e-15);
  }
}

TEST(MinimumJerkDetour, StartsAndEndsAtRestAtZero) {
  for (const double peak : {0.1, 0.35, 0.5, 0.9}) {
    for (const double end : {0.0, 1.0}) {
      EXPECT_NEAR(minimum_jerk_detour(end, peak), 0.0, 1e-12);
      // a third-order zero: a step of 1e-4 reaches no farther than jerk · 1e-12 / 6, the jerk of a
      // peak at 0.1 or 0.9 staying below 60 · 10³ · 10²
      const double inside = end == 0.0 ? 1e-4 : 1.0 - 1e-4;
      EXPECT_NEAR(minimum_jerk_detour(inside, peak), 0.0, 1e-6);
    }
  }
}

TEST(MinimumJerkDetour, StaysAtZeroOutsideOfItsTime) {
  EXPECT_EQ(minimum_jerk_detour(-0.5, 0.3), 0.0);
  EXPECT_NEAR(minimum_jerk_detour(1.5, 0.3), 0.0, 1e-12);
}

TEST(MinimumJerkDetour, IsSymmetricAboutAPeakInTheMiddle) {
  for (double t = 0.0; t <= 0.5; t += 0.05) {
    EXPECT_NEAR(minimum_jerk_detour(t, 0.5), minimum_jerk_detour(1.0 - t, 0.5), 1e-12);
  }
}

TEST(MinimumJerkDetour, HasContinuousJerkAtItsPeak) {
  for (const double peak : {0.2, 0.5, 0.7}) {
    EXPECT_NEAR(jerk(peak - 0.004, peak), jerk(peak + 0.004, peak),
                0.1 * std::abs(jerk(0.01, peak)));
  }
}

TEST(MinimumJerkDetour, HasTheLeastJerkOfAllWaysThroughItsPeak) {
  for (const double peak : {0.3, 0.5, 0.6}) {
    EXPECT_LT(jerk_cost(peak, 0.0), jerk_cost(peak, 0.1));
    EXPECT_LT(jerk_cost(peak, 0.0), jerk_cost(peak, -0.1));
  }
}

TEST(EffectorPath, PassesItsViaPoint) {
  const EffectorPath path{{0, 1, 0}, {1, 1, 0}, {0, 0, 0.2}, 0.4};
  EXPECT_NEAR(path.at(0.4).z, 0.2, 1e-15);
  EXPECT_NEAR(path.at(0.4).x, minimum_jerk(0.4), 1e-15);
}

TEST(EffectorPath, EndsAtItsGoalWhateverItsDetour) {
  const EffectorPath path{{0, 1, 0}, {1, 1, 0}, {0.3, 0.1, 0.2}, 0.4};
  EXPECT_NEAR(norm(path.at(1.0) - path.goal), 0.0, 1e-12);
}

}  // namespace
}  // namespace shigusa
