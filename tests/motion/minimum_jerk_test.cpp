// SPDX-License-Identifier: MIT
#include "motion/minimum_jerk.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace shigusa {
namespace {

// Derivatives of 10τ³ - 15τ⁴ + 6τ⁵.
double speed(double t) { return 30 * t * t * (1 - t) * (1 - t); }
double acceleration(double t) { return 60 * t * (1 - t) * (1 - 2 * t); }

TEST(MinimumJerk, IsItsClosedForm) {
  for (int i = 0; i <= 1000; ++i) {
    const long double t = i / 1000.0;
    const long double expected = 10 * t * t * t - 15 * t * t * t * t + 6 * t * t * t * t * t;
    // half a dozen roundings of numbers up to 15
    EXPECT_NEAR(minimum_jerk(static_cast<double>(t)), static_cast<double>(expected), 1e-14);
  }
}

TEST(MinimumJerk, GoesFromZeroToOne) {
  EXPECT_EQ(minimum_jerk(0.0), 0.0);
  EXPECT_EQ(minimum_jerk(1.0), 1.0);
  EXPECT_EQ(minimum_jerk(0.5), 0.5);
}

TEST(MinimumJerk, StaysPutOutsideOfItsTime) {
  EXPECT_EQ(minimum_jerk(-1.0), 0.0);
  EXPECT_EQ(minimum_jerk(2.0), 1.0);
}

TEST(MinimumJerk, StartsAndEndsWithoutSpeedOrAcceleration) {
  // s = 10 h³ near an end: its difference quotients vanish as h² and h
  constexpr double h = 1e-4;
  EXPECT_NEAR(minimum_jerk(h) / h, 0.0, 11 * h * h);
  EXPECT_NEAR((1 - minimum_jerk(1 - h)) / h, 0.0, 11 * h * h);
  EXPECT_NEAR((minimum_jerk(2 * h) - 2 * minimum_jerk(h)) / (h * h), 0.0, 61 * h);
  EXPECT_NEAR((1 - minimum_jerk(1 - 2 * h) - 2 * (1 - minimum_jerk(1 - h))) / (h * h), 0.0, 61 * h);
}

TEST(MinimumJerk, DifferenceQuotientsAreItsDerivatives) {
  constexpr double h = 1e-4;
  for (double t = 0.05; t < 0.96; t += 0.05) {
    const double before = minimum_jerk(t - h);
    const double after = minimum_jerk(t + h);
    // errors h² / 6 and h² / 12 times the third and fourth derivatives, which are below 60 and 360,
    // and rounding over h²
    EXPECT_NEAR((after - before) / (2 * h), speed(t), 10 * h * h);
    EXPECT_NEAR((after - 2 * minimum_jerk(t) + before) / (h * h), acceleration(t),
                31 * h * h + 1e-7);
  }
}

TEST(MinimumJerk, LargestSpeedIsFifteenEighthsOfTheMean) {
  constexpr double h = 1e-4;
  EXPECT_NEAR((minimum_jerk(0.5 + h) - minimum_jerk(0.5 - h)) / (2 * h), 1.875, 11 * h * h);
}

TEST(MinimumJerk, CostOfJerkIs720) {
  // ∫ s'''² dτ = 720 (in units of D² / T⁵) from third differences, by the midpoint rule: both have
  // errors of the order of h²
  constexpr int n = 1000;
  constexpr double h = 1.0 / n;
  double cost = 0.0;
  for (int i = 1; i + 2 <= n; ++i) {
    const double jerk = (minimum_jerk((i + 2) * h) - 3 * minimum_jerk((i + 1) * h) +
                         3 * minimum_jerk(i * h) - minimum_jerk((i - 1) * h)) /
                        (h * h * h);
    cost += jerk * jerk * h;
  }
  // the first and the last step, which no such difference reaches, have a jerk near 60
  cost += 2 * 60.0 * 60.0 * h;
  EXPECT_NEAR(cost, 720.0, 0.1);
}

RC_GTEST_PROP(MinimumJerkProperty, NeverTurnsBack, ()) {
  const double a = *rc::gen::inRange(-2000, 12000) / 1e4;
  const double b = a + *rc::gen::inRange(0, 2000) / 1e6;
  RC_ASSERT(minimum_jerk(a) <= minimum_jerk(b) + 1e-14);
  RC_ASSERT(minimum_jerk(a) >= 0.0 && minimum_jerk(a) <= 1.0);
}

TEST(EffectorPath, LeadsStraightFromStartToGoal) {
  const EffectorPath path{{0.1, 0.2, 0.3}, {0.7, -0.4, 1.5}};
  EXPECT_EQ(path.at(0.0), path.start);
  EXPECT_LT(norm(path.at(1.0) - path.goal), 1e-15);
  const Vec3d way = path.goal - path.start;
  for (double tau = 0.0; tau <= 1.0; tau += 0.05) {
    EXPECT_LT(norm(path.at(tau) - path.start - way * minimum_jerk(tau)), 1e-15);
  }
}

TEST(CarriedOn, BeginsWithTheSpeedAndEndsAtRestWhereItBegan) {
  constexpr double kStep = 1e-4;
  const auto speed = [](double t) {
    return (carried_on(t + kStep) - carried_on(t - kStep)) / (2.0 * kStep);
  };
  const auto acceleration = [](double t) {
    return (carried_on(t + kStep) - 2.0 * carried_on(t) + carried_on(t - kStep)) / (kStep * kStep);
  };
  EXPECT_EQ(carried_on(0.0), 0.0);
  EXPECT_NEAR(carried_on(1.0), 0.0, 1e-15);
  EXPECT_NEAR(speed(0.0), 1.0, 1e-6);
  EXPECT_NEAR(speed(1.0), 0.0, 1e-6);
  EXPECT_NEAR(acceleration(0.0), 0.0, 1e-6);
  EXPECT_NEAR(acceleration(1.0), 0.0, 1e-6);
}

TEST(EffectorPath, WithMomentumBeginsWithItsVelocityAndMeetsItsGoal) {
  EffectorPath path{.start = {0, 1, 0}, .goal = {1, 1, 2}};
  path.momentum = {0.5, -0.3, 0.1};
  EXPECT_EQ(path.at(0.0), path.start);
  EXPECT_LT(norm(path.at(1.0) - path.goal), 1e-15);
  constexpr double kStep = 1e-5;
  EXPECT_LT(norm((path.at(kStep) - path.at(0.0)) * (1.0 / kStep) - path.momentum), 1e-8);
}

TEST(MinimumSnap, HasTheSpeedOfItsClosedForm) {
  EXPECT_EQ(minimum_snap(0.0), 0.0);
  EXPECT_NEAR(minimum_snap(0.5), 0.5, 1e-15);
  EXPECT_NEAR(minimum_snap(1.0), 1.0, 1e-14);
  constexpr double h = 1e-4;
  for (double t = 0.05; t < 0.96; t += 0.05) {
    const double expected = 140 * t * t * t * (1 - t) * (1 - t) * (1 - t);
    // an error of h² / 6 times the third derivative, which is below 60
    EXPECT_NEAR((minimum_snap(t + h) - minimum_snap(t - h)) / (2 * h), expected, 10 * h * h);
  }
}

TEST(MinimumSnap, StaysPutOutsideOfItsTime) {
  EXPECT_EQ(minimum_snap(-1.0), 0.0);
  EXPECT_EQ(minimum_snap(2.0), minimum_snap(1.0));
}

TEST(MinimumSnap, BeginsAndEndsWithoutJerk) {
  // s = 35 h⁴ near an end: over h³ it vanishes with h
  constexpr double h = 1e-3;
  EXPECT_NEAR(minimum_snap(h) / (h * h * h), 0.0, 36 * h);
  EXPECT_NEAR((1 - minimum_snap(1 - h)) / (h * h * h), 0.0, 36 * h);
}

// Time (of the duration) of the peak velocity of the minimum-jerk profile with such a haste, by
// differences.
double fastest_at(double haste) {
  constexpr double kStep = 1e-3;
  double most = 0.0;
  double at = 0.0;
  for (double t = 0.5 * kStep; t < 1.0; t += kStep) {
    const double gone = minimum_jerk(hastened(t + 0.5 * kStep, haste)) -
                        minimum_jerk(hastened(t - 0.5 * kStep, haste));
    if (gone <= most) continue;
    most = gone;
    at = t;
  }
  return at;
}

constexpr double kHastes[] = {-1.0, -0.25, 0.0, 0.07, 0.4, 1.0};

TEST(Hastened, BeginsAndEndsWithTheTime) {
  for (const double haste : kHastes) {
    EXPECT_EQ(hastened(0.0, haste), 0.0);
    EXPECT_EQ(hastened(1.0, haste), 1.0);
  }
}

TEST(Hastened, WithoutHasteIsTheTime) {
  for (const double t : {0.1, 0.3, 0.77}) EXPECT_EQ(hastened(t, 0.0), t);
}

TEST(Hastened, IsQuickerInTheFirstHalfByTheHaste) {
  for (const double haste : kHastes) {
    const double first = hastened(0.5, haste) / 0.5;
    const double second = (1.0 - hastened(0.5, haste)) / 0.5;
    EXPECT_NEAR(first - second, haste, 1e-15);
  }
}

TEST(Hastened, BackwardsIsTheOppositeHaste) {
  for (const double haste : kHastes) {
    for (const double t : {0.0, 0.2, 0.5, 0.9}) {
      EXPECT_NEAR(1.0 - hastened(1.0 - t, haste), hastened(t, -haste), 1e-15);
    }
  }
}

RC_GTEST_PROP(HastenedProperty, NeverTurnsBack, ()) {
  const double haste = *rc::gen::inRange(-1000, 1001) / 1e3;
  const double a = *rc::gen::inRange(0, 10000) / 1e4;
  const double b = min(a + *rc::gen::inRange(0, 2000) / 1e4, 1.0);
  RC_ASSERT(hastened(a, haste) <= hastened(b, haste) + 1e-15);
}

TEST(Hastened, MovesTheGreatestSpeed) {
  // as its comment says
  EXPECT_NEAR(fastest_at(0.0), 0.50, 0.005);
  EXPECT_NEAR(fastest_at(0.22), 0.41, 0.005);
  EXPECT_NEAR(fastest_at(-0.15), 0.57, 0.005);
  double before = 1.0;
  for (const double haste : kHastes) {
    EXPECT_LT(fastest_at(haste), before);
    before = fastest_at(haste);
  }
}

// A path with a detour, and the same with haste.
struct Paths {
  EffectorPath even{.start = {0.1, 0.2, 0.3}, .goal = {0.7, -0.4, 1.5}, .detour = {0, 0.1, 0}};
  EffectorPath hasty = even;

  explicit Paths(double haste) { hasty.haste = haste; }
};

TEST(EffectorPath, HasteChangesWhenItIsWhereAndNotWhere) {
  for (const double haste : kHastes) {
    const Paths paths(haste);
    for (double tau = 0.0; tau <= 1.0; tau += 0.05) {
      EXPECT_LT(norm(paths.hasty.at(tau) - paths.even.at(hastened(tau, haste))), 1e-15);
    }
  }
}

TEST(EffectorPath, WithHasteBeginsAndEndsAtRestWhereItDoesWithout) {
  constexpr double kStep = 1e-4;
  for (const double haste : kHastes) {
    const Paths paths(haste);
    EXPECT_EQ(paths.hasty.at(0.0), paths.even.start);
    EXPECT_LT(norm(paths.hasty.at(1.0) - paths.even.goal), 1e-15);
    // at most 10 (2 h)³ of a line of 1.5 m, and a detour whose own cube is 16 times as steep
    EXPECT_LT(norm(paths.hasty.at(kStep) - paths.even.start), 200 * kStep * kStep * kStep);
    EXPECT_LT(norm(paths.hasty.at(1.0 - kStep) - paths.even.goal), 200 * kStep * kStep * kStep);
  }
}

TEST(EffectorPath, StaysUntilItBegins) {
  Paths paths(0.3);
  paths.hasty.begin = 0.2;
  for (const double tau : {0.0, 0.1, 0.2}) {
    EXPECT_EQ(paths.hasty.own_time(tau), 0.0);
    EXPECT_EQ(paths.hasty.at(tau), paths.even.start);
  }
  EXPECT_GT(paths.hasty.own_time(0.21), 0.0);
}

TEST(EffectorPath, HasTheRestOfTheTimeOnceItHasBegun) {
  for (const double haste : kHastes) {
    Paths paths(haste);
    const EffectorPath at_once = paths.hasty;
    paths.hasty.begin = 0.2;
    for (double own = 0.0; own <= 1.0; own += 0.05) {
      // in 0.8 of the time
      EXPECT_LT(norm(paths.hasty.at(0.2 + 0.8 * own) - at_once.at(own)), 1e-14);
    }
    EXPECT_LT(norm(paths.hasty.at(1.0) - paths.even.goal), 1e-15);
  }
}

TEST(EffectorPath, DoneIsTheShareOfItsLine) {
  const EffectorPath path{
      .start = {0.1, 0.2, 0.3}, .goal = {0.7, -0.4, 1.5}, .begin = 0.1, .haste = 0.3};
  const Vec3d way = path.goal - path.start;
  for (double tau = 0.0; tau <= 1.0; tau += 0.05) {
    EXPECT_NEAR(path.done(tau), dot(path.at(tau) - path.start, way) / dot(way, way), 1e-15);
  }
}

TEST(ReachDuration, GrowsWithTheDistanceBetweenItsBounds) {
  EXPECT_DOUBLE_EQ(reach_duration(0.0, false), 0.6);
  EXPECT_DOUBLE_EQ(reach_duration(0.2, false), 0.6);
  EXPECT_DOUBLE_EQ(reach_duration(0.6, false), 0.9);
  EXPECT_DOUBLE_EQ(reach_duration(5.0, false), 2.0);
}

TEST(ReachDuration, TrunkTakesLonger) {
  EXPECT_DOUBLE_EQ(reach_duration(0.6, true), 1.04);
  EXPECT_DOUBLE_EQ(reach_duration(5.0, true), 2.14);
}

}  // namespace
}  // namespace shigusa
