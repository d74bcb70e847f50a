// SPDX-License-Identifier: MIT
#include "rollout/smooth_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/criteria.hpp>
#include <shigusa/human.hpp>

#include "body/posture_modes.hpp"
#include "core/index.hpp"
#include "motion/minimum_jerk.hpp"
#include "problem/make_problem.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr int kFrames = 61;

double tau(int frame) { return static_cast<double>(frame) / (kFrames - 1); }

TEST(SmoothFrames, LeavesAMinimumJerkMotionAlmostAsItIs) {
  std::vector<double> angles;
  for (int f = 0; f < kFrames; ++f) angles.push_back(minimum_jerk(tau(f)));
  const std::vector<double> before = angles;
  smooth_frames(1, angles);
  for (int f = 0; f < kFrames; ++f) EXPECT_NEAR(angles[index(f)], before[index(f)], 5e-4) << f;
}

TEST(SmoothFrames, KeepsTheEndsAndWhatIsAtRest) {
  // two freedoms: one stays, one goes evenly
  std::vector<double> angles;
  for (int f = 0; f < kFrames; ++f) angles.insert(angles.end(), {0.7, tau(f)});
  smooth_frames(2, angles);
  for (int f = 0; f < kFrames; ++f) EXPECT_NEAR(angles[2 * index(f)], 0.7, 1e-12);
  EXPECT_EQ(angles[1], 0.0);
  EXPECT_EQ(angles.back(), 1.0);
}

TEST(SmoothFrames, SpreadsASuddenStop) {
  std::vector<double> angles;
  for (int f = 0; f < kFrames; ++f) angles.push_back(std::min(tau(f), 0.5));
  const auto sharpest = [&angles] {
    double most = 0.0;
    for (std::size_t f = 20; f < 40; ++f) {
      most = std::max(most, std::abs(angles[f + 1] - 2.0 * angles[f] + angles[f - 1]));
    }
    return most;
  };
  const double before = sharpest();
  smooth_frames(1, angles);
  EXPECT_LT(sharpest(), 0.5 * before);
}

TEST(SmoothFrames, TakesShortClipsAsTheyAre) {
  std::vector<double> angles{0.0, 1.0};
  smooth_frames(1, angles);
  EXPECT_EQ(angles, (std::vector<double>{0.0, 1.0}));
  angles = {0.0, 1.0, 2.0};
  smooth_frames(1, angles);
  EXPECT_EQ(angles[0], 0.0);
  EXPECT_EQ(angles[2], 2.0);
}

TEST(SmoothedMotion, KeepsItsPathAndItsFeetAndIsLessSudden) {
  const PosedBody posed = human_body({});
  const Task task(posed, {.goals = {{"right_hand", {-0.15, 0.15, 0.35}}}});
  const ReachProblem problem = make_problem(task).value();
  for (const double squat : {20.0, 100.0}) {
    Parameters parameters = uniform_parameters(posed);
    pose(posed, parameters,
         [&](const PostureMode& mode) { return mode.name == "squat" ? radians(squat) : 0.0; });
    const RolledOut rough = roll_out(problem, parameters);
    ASSERT_TRUE(rough.outcome.met(problem.tolerance)) << squat;
    const RolledOut smooth = smoothed(problem, parameters, rough);
    EXPECT_TRUE(smooth.outcome.met(problem.tolerance)) << squat;
    EXPECT_LT(smooth.outcome.path_error, 1e-4) << squat;
    EXPECT_LT(suddenness(posed, smooth.motion).pressure, suddenness(posed, rough.motion).pressure);
    EXPECT_LT(suddenness(posed, smooth.motion).torque, suddenness(posed, rough.motion).torque);
  }
}

TEST(SmoothedMotion, IsTheRoughOneWhereThatMisses) {
  const PosedBody posed = human_body({});
  const Task task(posed, {.goals = {{"right_hand", {-0.15, 1.0, 3.0}}}});
  const ReachProblem problem = make_problem(task).value();
  const RolledOut rough = roll_out(problem, uniform_parameters(posed));
  ASSERT_FALSE(rough.outcome.met(problem.tolerance));
  const RolledOut smooth = smoothed(problem, uniform_parameters(posed), rough);
  EXPECT_EQ(smooth.motion.clip.angles, rough.motion.clip.angles);
}

}  // namespace
}  // namespace shigusa
