// SPDX-License-Identifier: MIT
#include "rollout/limit_guard.hpp"

#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"
#include "body/posture_modes.hpp"
#include "criteria/joint_range.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// the largest excess (rad) of any angle beyond its limit in any frame
double largest_excess(const PosedBody& posed, const Clip& clip) {
  double largest = 0.0;
  for (int f = 0; f < clip.frames; ++f) {
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      const double angle = clip.frame(f)[static_cast<std::size_t>(d)];
      largest = max(largest, angle - upper_limit(posed, d, clip.frame(f)));
      largest = max(largest, posed.body.dof(d).lower - angle);
    }
  }
  return largest;
}

ReachProblem held(ReachProblem problem) {
  problem.hold_limits = true;
  problem.corrections = 2;
  problem.path_slack = 3e-4;
  return problem;
}

Parameters random_posture(const PosedBody& posed, Random& random) {
  Parameters parameters = random_parameters(posed, random);
  pose(posed, parameters,
       [&](const PostureMode& mode) { return random.uniform(mode.lower, mode.upper); });
  value_of(posed, parameters, "delay") = random.uniform(0.0, kDelayMax);
  return parameters;
}

TEST(LimitGuard, NoMotionPassesALimitWhateverItIsDrawnTo) {
  Random random(31);
  int pushed = 0;  // motions that pass a limit where nothing holds them
  for (const PosedBody& posed : {half_body(), full_body()}) {
    for (int i = 0; i < 150; ++i) {
      const Vec3d goal{random.uniform(-0.6, 0.2), random.uniform(0.0, 1.9),
                       random.uniform(0.1, 0.7)};
      const ReachProblem problem = reach_with(posed, "right_hand", goal);
      const Parameters parameters = random_posture(posed, random);
      const RolledOut free = roll_out(problem, parameters);
      pushed += largest_excess(posed, free.motion.clip) > radians(1.0) ? 1 : 0;
      const RolledOut rolled = roll_out(held(problem), parameters);
      // a hip's limit depends on a knee that a correction can still move
      EXPECT_LE(largest_excess(posed, rolled.motion.clip), 1e-12) << posed.body.name() << ' ' << i;
    }
  }
  EXPECT_GT(pushed, 100);
}

TEST(LimitGuard, GoalIsStillMetWithOtherJoints) {
  Random random(5);
  int pushed = 0;  // met, but beyond a limit, where nothing holds it
  int met = 0;     // of these
  const PosedBody posed = full_body();
  for (int i = 0; i < 200; ++i) {
    const ReachProblem problem = reach_with(posed, "right_hand", near_goal(posed, random));
    const Parameters parameters = random_parameters(posed, random);
    const RolledOut free = roll_out(problem, parameters);
    if (!free.outcome.met() || largest_excess(posed, free.motion.clip) < radians(5.0)) continue;
    ++pushed;
    met += roll_out(held(problem), parameters).outcome.met() ? 1 : 0;
  }
  EXPECT_GT(pushed, 30);
  EXPECT_GE(met, pushed * 95 / 100);
}

TEST(LimitGuard, SharesFallToNothingTowardsALimitAndNotAwayFromIt) {
  const PosedBody posed = half_body();
  const std::size_t knee =
      static_cast<std::size_t>(posed.body.find_dof("right_knee.flexion").value());
  LimitGuard<double> guard(posed, posed.home);
  const std::vector<double> weights(posed.body.dofs().size(), 2.0);
  std::vector<double> pull(posed.body.dofs().size());
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  pull[knee] = 0.01;  // wants to bend further
  guard.learn(weights, pull, {});
  angles[knee] = posed.body.dofs()[knee].upper - 0.25 * kLimitMargin;
  EXPECT_NEAR(guard.soften(weights, angles)[knee], 2.0 * 0.25 * (2.0 - 0.25), 1e-12);
  angles[knee] = posed.body.dofs()[knee].upper;
  EXPECT_EQ(guard.soften(weights, angles)[knee], 0.0);
  EXPECT_EQ(guard.allowed(pull)[knee], 0.0);
  pull[knee] = -0.01;  // wants to stretch: gets its weight back step by step
  for (double share = kLimitRise; share < 1.0; share += kLimitRise) {
    guard.learn(weights, pull, {});
    EXPECT_NEAR(guard.soften(weights, angles)[knee], 2.0 * share, 1e-12);
  }
  guard.learn(weights, pull, {});
  EXPECT_EQ(guard.soften(weights, angles)[knee], 2.0);
  EXPECT_EQ(guard.allowed(pull)[knee], -0.01);
}

// A guard that has not softened yet, or that is reset, gives a joint with room its full weight,
// also when it first learns the joint's direction.
TEST(LimitGuard, BeginsWithFullShares) {
  const PosedBody posed = half_body();
  const std::size_t knee =
      static_cast<std::size_t>(posed.body.find_dof("right_knee.flexion").value());
  const Dof& dof = posed.body.dofs()[knee];
  const std::vector<double> weights(posed.body.dofs().size(), 1.0);
  std::vector<double> pull(posed.body.dofs().size());
  pull[knee] = 0.01;
  std::vector<double> amid(posed.home.angles.begin(), posed.home.angles.end());
  amid[knee] = 0.5 * (dof.lower + dof.upper);
  std::vector<double> bent(amid);
  bent[knee] = dof.upper;
  for (const bool learns_first : {false, true}) {
    LimitGuard<double> guard(posed, posed.home);
    for (int motion = 0; motion < 2; ++motion) {
      if (learns_first) guard.learn(weights, pull, {});
      EXPECT_EQ(guard.soften(weights, amid)[knee], 1.0) << learns_first << motion;
      // until its limit has held it
      guard.learn(weights, pull, {});
      EXPECT_EQ(guard.soften(weights, bent)[knee], 0.0);
      guard.learn(weights, pull, {});
      EXPECT_NEAR(guard.soften(weights, amid)[knee], kLimitRise, 1e-12);
      guard.reset();
    }
  }
}

// A joint that would reach its limit within two steps yields already, however far that is, whether
// the goal or the posture moves it there.
TEST(LimitGuard, AFastJointGivesWayEarlier) {
  const PosedBody posed = half_body();
  const std::size_t knee =
      static_cast<std::size_t>(posed.body.find_dof("right_knee.flexion").value());
  LimitGuard<double> guard(posed, posed.home);
  const std::vector<double> weights(posed.body.dofs().size(), 1.0);
  std::vector<double> pull(posed.body.dofs().size());
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  angles[knee] = posed.body.dofs()[knee].upper - 2.0 * kLimitMargin;
  pull[knee] = 0.1 * kLimitMargin;
  guard.learn(weights, pull, {});
  EXPECT_EQ(guard.soften(weights, angles)[knee], 1.0);
  pull[knee] = kLimitMargin;
  guard.learn(weights, pull, {});
  const double left = 2.0 / kLimitSteps;
  EXPECT_NEAR(guard.soften(weights, angles)[knee], left * (2.0 - left), 1e-12);
  guard.reset();
  pull[knee] = 0.5 * kLimitMargin;
  const std::vector<double> reference(pull);
  guard.learn(weights, pull, reference);
  EXPECT_NEAR(guard.soften(weights, angles)[knee], left * (2.0 - left), 1e-12);
}

// A human whose heels may lift, with the indices of the right toes and ankle.
class Lifting : public testing::Test {
 protected:
  static constexpr double kPull = 0.01;    // rad, towards a goal
  static constexpr double kDrawn = 0.015;  // rad, towards a posture
  // slow enough to give way over the least margin only
  static_assert((kPull + kDrawn) * kLimitSteps < kLimitMargin);

  const PosedBody posed = human_body({.heels = true});
  const std::size_t toes =
      static_cast<std::size_t>(posed.body.find_dof("right_toes.flexion").value());
  const std::size_t ankle =
      static_cast<std::size_t>(posed.body.find_dof("right_ankle.flexion").value());
  LimitGuard<double> guard{posed, posed.home};
  std::vector<double> weights = std::vector<double>(posed.body.dofs().size(), 1.0);
  std::vector<double> pull = std::vector<double>(posed.body.dofs().size());
  std::vector<double> angles{posed.home.angles.begin(), posed.home.angles.end()};
};

TEST_F(Lifting, ToesGiveLittleWhileTheAnkleHasRoom) {
  pull[toes] = pull[ankle] = kPull;
  guard.learn(weights, pull, {});
  EXPECT_NEAR(guard.soften(weights, angles)[toes], kToesGive, 1e-12);
  EXPECT_EQ(guard.allowed(pull)[toes], kPull);
  guard.loosen();
  EXPECT_EQ(guard.soften(weights, angles)[toes], 1.0);
}

TEST_F(Lifting, ToesTakeOverAsTheAnkleRunsOut) {
  std::vector<double> reference(pull);
  reference[ankle] = kDrawn;
  pull[toes] = pull[ankle] = kPull;
  angles[ankle] = posed.body.dofs()[ankle].upper - 0.25 * kLimitMargin;
  guard.learn(weights, pull, reference);
  (void)guard.soften(weights, angles);
  guard.learn(weights, pull, reference);
  const std::span<const double> softened = guard.soften(weights, angles);
  const double left = 0.25 * (2.0 - 0.25);
  EXPECT_NEAR(softened[ankle], left, 1e-12);
  EXPECT_NEAR(softened[toes], 1.0 - left + kToesGive, 1e-12);
  const std::span<const double> allowed = guard.allowed(reference);
  EXPECT_NEAR(allowed[ankle] + allowed[toes], reference[ankle], 1e-12);
}

TEST_F(Lifting, ToesOfMoreWeightTakeOverLessAndLockedOnesNothing) {
  std::vector<double> reference(pull);
  reference[ankle] = kDrawn;
  pull[toes] = pull[ankle] = kPull;
  angles[ankle] = posed.body.dofs()[ankle].upper;
  for (const double inverse : {0.1, 0.0}) {
    weights[toes] = inverse;
    guard.learn(weights, pull, reference);
    (void)guard.soften(weights, angles);
    guard.learn(weights, pull, reference);
    EXPECT_NEAR(guard.soften(weights, angles)[toes], inverse * (1.0 + kToesGive), 1e-12);
    EXPECT_NEAR(guard.allowed(reference)[toes], inverse * reference[ankle], 1e-12);
  }
}

// At the other end of its range an ankle passes nothing to the toes.
TEST_F(Lifting, ToesStayAsTheAnklePointsDown) {
  pull[toes] = kPull;
  pull[ankle] = -kPull;
  angles[ankle] = posed.body.dofs()[ankle].lower;
  guard.learn(weights, pull, {});
  EXPECT_NEAR(guard.soften(weights, angles)[toes], kToesGive, 1e-12);
}

TEST(LimitGuard, HoldsAHipByWhatItsKneeAllows) {
  const PosedBody posed = full_body();
  const std::size_t knee =
      static_cast<std::size_t>(posed.body.find_dof("left_knee.flexion").value());
  const std::size_t hip = static_cast<std::size_t>(posed.body.find_dof("left_hip.flexion").value());
  LimitGuard<double> guard(posed, posed.home);
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  angles[hip] = 3.0;
  angles[knee] = 0.0;
  guard.hold(angles);
  const double straight = angles[hip];
  angles[hip] = 3.0;
  angles[knee] = radians(60.0);
  guard.hold(angles);
  EXPECT_NEAR(straight, posed.body.dofs()[hip].upper, 1e-12);
  EXPECT_NEAR(angles[hip] - straight, radians(50.0), 1e-12);
}

}  // namespace
}  // namespace shigusa
