// SPDX-License-Identifier: MIT
#include "criteria/work.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/inverse_dynamics.hpp"
#include "support/motions.hpp"
#include "support/penalty_by.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// 2 kg at the end of a rod of 0.5 m.
const PosedBody& rod() {
  static const PosedBody posed = chain({{Axis::x, 0.5, 2.0}});
  return posed;
}

// The rod moved through these angles so slowly that only its weight acts.
Motion led_through(const std::vector<double>& angles) {
  std::vector<std::vector<double>> frames;
  for (const double angle : angles) frames.push_back({angle});
  Motion motion = motion_through(rod(), frames);
  DynamicsWorkspace<double> work(rod());
  const std::vector<double> still{0.0};
  for (std::size_t f = 0; f < frames.size(); ++f) {
    (void)inverse_dynamics<double>(rod(), placed(rod(), frames[f]), {still, still}, work,
                                   std::span(motion.torques).subspan(f, 1));
  }
  return motion;
}

std::vector<double> from_to(double from, double to, int steps) {
  std::vector<double> angles;
  for (int f = 0; f <= steps; ++f) angles.push_back(from + (to - from) * f / steps);
  return angles;
}

// The criterion's value in joules.
double work_of(const Motion& motion) {
  return penalty_by<Work>(rod(), motion) * full_work(rod(), kWorkShare);
}

TEST(Work, HasItsScaleFromTheBody) {
  EXPECT_NEAR(full_work(rod(), kWorkShare), 0.4 * 2.0 * kGravity * 0.5, 1e-12);
}

TEST(Work, OfRestIsZero) { EXPECT_EQ(work_of(led_through({0.3, 0.3, 0.3})), 0.0); }

// Sums over 1000 steps are the trapezoidal rule: off by (step² / 12) · |Δ slope of the torque|.
TEST(Work, OfLiftingIsWeightTimesHeight) {
  const double height = 0.5 * (1.0 - std::cos(0.6));
  EXPECT_NEAR(work_of(led_through(from_to(0.6, 0.0, 1000))), 2.0 * kGravity * height, 1e-6);
}

TEST(Work, OfLoweringIsTheSame) {
  const double height = 0.5 * (1.0 - std::cos(0.6));
  EXPECT_NEAR(work_of(led_through(from_to(0.0, 0.6, 1000))), 2.0 * kGravity * height, 1e-6);
}

TEST(Work, OfThereAndBackIsTwiceThat) {
  std::vector<double> angles = from_to(0.0, 0.4, 1000);
  const double once = work_of(led_through(angles));
  for (const double angle : from_to(0.4, 0.0, 1000)) angles.push_back(angle);
  EXPECT_NEAR(work_of(led_through(angles)), 2.0 * once, 1e-6);
}

TEST(Work, DoesNotDependOnTheTimeTaken) {
  Motion motion = led_through(from_to(0.0, 0.4, 20));
  const double before = work_of(motion);
  motion.clip.frame_time *= 3.0;
  EXPECT_NEAR(work_of(motion), before, 1e-12);
}

TEST(Work, IsFullAtItsShareAndBeyond) {
  Motion motion = led_through(from_to(0.0, 0.4, 20));
  for (double& tau : motion.torques) tau *= 1e3;
  EXPECT_EQ(penalty_by<Work>(rod(), motion), 1.0);
}

TEST(Work, ShareIsASetting) {
  const Motion motion = led_through(from_to(0.0, 0.4, 20));
  EXPECT_NEAR(penalty_by<Work>(rod(), motion, 0.8), 0.5 * penalty_by<Work>(rod(), motion), 1e-12);
}

}  // namespace
}  // namespace shigusa
