// SPDX-License-Identifier: MIT
#include "rollout/rollout.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "dynamics/centre_of_mass.hpp"
#include "plan/held_input.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// In front of the right foot, at knee height: the whole body must help.
constexpr Vec3d kLow{-0.1, 0.5, 0.5};

TEST(ReachOutcome, IsMetWithinAMillimetreAndATenthOfADegree) {
  EXPECT_EQ(kReachTolerance, 1e-3);
  EXPECT_NEAR(degrees(kTiltTolerance), 0.1, 1e-15);
  EXPECT_TRUE((ReachOutcome{.goal_error = 0.9e-3, .contact_slide = 0.9e-3}.met()));
  EXPECT_FALSE((ReachOutcome{.goal_error = 1.1e-3}.met()));
  EXPECT_FALSE((ReachOutcome{.contact_slide = 1.1e-3}.met()));
  EXPECT_FALSE((ReachOutcome{.contact_tilt = radians(0.11)}.met()));
  EXPECT_FALSE((ReachOutcome{.path_error = 1.1e-3}.met()));
  EXPECT_TRUE((ReachOutcome{.goal_error = 4e-3, .path_error = 4e-3}.met({5e-3, 5e-3})));
  EXPECT_FALSE((ReachOutcome{.goal_error = 4e-3, .path_error = 6e-3}.met({5e-3, 5e-3})));
}

TEST(Constraints, AreTheGoalsAndThenThePlantedFoot) {
  const ReachProblem problem = reach_with(full(), "left_hand", kLow);
  const auto all = constraints(problem);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_FALSE(all[0].exact);
  EXPECT_EQ(all[0].place, kLow);
  EXPECT_TRUE(all[1].exact);
  EXPECT_EQ(all[1].link, full().body.feet()[1].link);
  const Kinematics<double> start = placed(full(), full().home.angles);
  EXPECT_EQ(all[1].place, start.point(all[1].link, all[1].point));
}

TEST(Constraints, LeaveOutTheFootThatIsTheBase) {
  EXPECT_EQ(constraints(reach_with(half(), "right_hand", kLow)).size(), 1u);
}

TEST(RollOut, HasAFrameMoreThanSteps) {
  ReachProblem problem = reach_with(half(), "right_hand", kLow);
  problem.duration = 1.5;
  const RolledOut rolled = roll_out(problem, uniform_parameters(half()));
  EXPECT_EQ(kMotionSteps, 60);
  EXPECT_EQ(rolled.motion.clip.frames, 61);
  EXPECT_DOUBLE_EQ(rolled.motion.clip.duration(), 1.5);
  EXPECT_EQ(rolled.motion.clip.angles.size(), 61u * 9u);
  EXPECT_EQ(rolled.motion.torques.size(), 61u * 9u);
  EXPECT_EQ(rolled.motion.centre_of_mass.size(), 61u);
  ASSERT_EQ(rolled.motion.effectors.size(), 1u);
  EXPECT_EQ(rolled.motion.effectors[0].size(), 61u);
}

TEST(RollOut, SaysWhereTheHandAndTheCentreOfMassAre) {
  const ReachProblem problem = reach_with(full(), "right_hand", kLow);
  const Motion motion = roll_out(problem, uniform_parameters(full())).motion;
  for (int f = 0; f < motion.clip.frames; ++f) {
    const auto k = static_cast<std::size_t>(f);
    EXPECT_EQ(motion.effectors[0][k],
              effector_position(full(), motion.clip.frame(f), "right_hand"));
    const Vec3d expected = centre_of_mass(full(), placed(full(), motion.clip.frame(f)));
    EXPECT_LT(norm(motion.centre_of_mass[k] - expected), 1e-15);
  }
}

TEST(RollOut, OutcomeIsWhatTheMotionDoes) {
  const ReachProblem problem = reach_with(full(), "right_hand", kLow);
  Random random(81);
  for (int trial = 0; trial < 20; ++trial) {
    const RolledOut rolled = roll_out(problem, random_parameters(full(), random));
    const MeasuredMotion measured(problem, rolled.motion.clip);
    EXPECT_NEAR(rolled.outcome.path_error, measured.path_error, 1e-12);
    EXPECT_NEAR(rolled.outcome.goal_error, measured.goal_error, 1e-12);
    // 2 sin(θ / 2) instead of the angle: θ³ / 24 less
    EXPECT_NEAR(rolled.outcome.contact_tilt, measured.contact_tilt, 1e-10);
    // measured at the sole's corners, reported for its centre: a tilt lifts corners by half its
    // length
    EXPECT_LE(rolled.outcome.contact_slide, measured.contact_slide + 1e-12);
    EXPECT_LE(measured.contact_slide,
              rolled.outcome.contact_slide + 0.15 * measured.contact_tilt + 1e-12);
  }
}

TEST(RollOut, TheHandArrivesAtRest) {
  // the profile's last steps: s'' near the end is 60 τ², so the last of 60 moves 10 / 60³ of the
  // way
  const ReachProblem problem = reach_with(half(), "right_hand", kLow);
  const Motion motion = roll_out(problem, uniform_parameters(half())).motion;
  const double way = norm(problem.goals[0].path.goal - problem.goals[0].path.start);
  EXPECT_LT(norm(motion.effectors[0][60] - motion.effectors[0][59]), 11.0 / (60 * 60 * 60) * way);
  EXPECT_LT(norm(motion.effectors[0][1] - motion.effectors[0][0]), 11.0 / (60 * 60 * 60) * way);
}

TEST(RollOut, ReachingForWhereTheHandIsMovesNothing) {
  const Vec3d here = effector_position(full(), full().home.angles, "right_hand");
  const RolledOut rolled =
      roll_out(reach_with(full(), "right_hand", here), uniform_parameters(full()));
  const MeasuredMotion measured(reach_with(full(), "right_hand", here), rolled.motion.clip);
  EXPECT_EQ(measured.largest_step, 0.0);
}

TEST(RollOut, SlowMotionTakesTheTorqueOfStandingStill) {
  ReachProblem problem = reach_with(half(), "right_hand", kLow);
  problem.duration = 1e6;
  const Motion motion = roll_out(problem, uniform_parameters(half())).motion;
  const std::vector<double> still(9, 0.0);
  DynamicsWorkspace<double> work(half());
  std::vector<double> tau(9);
  for (int f = 0; f < motion.clip.frames; ++f) {
    inverse_dynamics<double>(half(), placed(half(), motion.clip.frame(f)), {still, still}, work,
                             tau);
    for (std::size_t d = 0; d < 9; ++d) {
      EXPECT_NEAR(motion.torques[static_cast<std::size_t>(f) * 9 + d], tau[d], 1e-6);
    }
  }
}

TEST(RollOut, TorqueOfMovingFallsWithTheSquareOfTheTime) {
  const auto torques = [](double duration) {
    ReachProblem problem = reach_with(half(), "right_hand", kLow);
    problem.duration = duration;
    return roll_out(problem, uniform_parameters(half())).motion.torques;
  };
  const std::vector<double> still = torques(1e9);
  const std::vector<double> fast = torques(0.5);
  const std::vector<double> slow = torques(1.0);
  for (std::size_t i = 0; i < still.size(); ++i) {
    EXPECT_NEAR(fast[i] - still[i], 4.0 * (slow[i] - still[i]), 1e-9);
  }
}

TEST(Rollout, UsedAgainGivesTheSameMotion) {
  const ReachProblem problem = reach_with(full(), "right_hand", kLow);
  Random random(82);
  const Parameters first = random_parameters(full(), random);
  const Parameters second = random_parameters(full(), random);
  Rollout<double> rollout(problem);
  const auto angles_of = [&](const Parameters& parameters) {
    std::vector<double> angles;
    rollout.run(inverse_weights(full(), parameters), [&](const PlacedFrame<double>& frame) {
      angles.insert(angles.end(), frame.angles.begin(), frame.angles.end());
    });
    return angles;
  };
  const std::vector<double> before = angles_of(first);
  (void)angles_of(second);
  EXPECT_EQ(angles_of(first), before);
  EXPECT_EQ(roll_out(problem, first).motion.clip.angles, before);
}

TEST(RollOut, EndsInItsGuideWhereThatArrives) {
  // the guide is a posture with the hand at the goal: the null space is drawn into it
  const ReachProblem plain = reach_with(half(), "right_hand", kLow);
  Random random(83);
  const Motion other = roll_out(plain, random_parameters(half(), random)).motion;
  ReachProblem guided = plain;
  const auto end = other.clip.frame(60);
  guided.guide.assign(end.begin(), end.end());
  const RolledOut rolled = roll_out(guided, uniform_parameters(half()));
  EXPECT_TRUE(rolled.outcome.met());
  for (std::size_t d = 0; d < 9; ++d) {
    EXPECT_NEAR(rolled.motion.clip.frame(60)[d], end[d], 1e-5) << d;
  }
}

TEST(RollOut, WithoutAPathOnlyTheLastFrameIsAtTheGoal) {
  ReachProblem guided = reach_with(full(), "right_hand", kLow);
  Random random(84);
  const Motion other = roll_out(guided, random_parameters(full(), random)).motion;
  guided.guide.assign(other.clip.frame(60).begin(), other.clip.frame(60).end());
  guided.follow_path = false;
  const RolledOut rolled = roll_out(guided, uniform_parameters(full()));
  EXPECT_TRUE(rolled.outcome.met());
  EXPECT_EQ(rolled.outcome.path_error, rolled.outcome.goal_error);
  const MeasuredMotion measured(guided, rolled.motion.clip);
  EXPECT_LT(measured.goal_error, kReachTolerance);
  EXPECT_GT(measured.path_error, kReachTolerance);
  EXPECT_LT(measured.contact_slide, kReachTolerance);
}

TEST(RollOut, BeyondReachItNeitherShakesNorBreaksApart) {
  for (const PosedBody* body : {&half(), &full()}) {
    const ReachProblem problem = reach_with(*body, "right_hand", {-3.0, 4.0, 5.0});
    const RolledOut rolled = roll_out(problem, uniform_parameters(*body));
    const MeasuredMotion measured(problem, rolled.motion.clip);
    EXPECT_TRUE(measured.finite);
    EXPECT_FALSE(rolled.outcome.met());
    // at most max_step in each of the step and its three corrections
    EXPECT_LT(measured.largest_step, 1.0);
  }
}

RC_GTEST_PROP(RollOutProperty, StartsInTheStartPostureAndKeepsTheFeetPlanted,
              (std::uint64_t seed, bool whole)) {
  const RandomReach reach(whole ? full() : half(), seed);
  const RolledOut rolled = roll_out(reach.problem, reach.parameters);
  const MeasuredMotion measured(reach.problem, rolled.motion.clip);
  RC_ASSERT(measured.finite);
  RC_ASSERT(measured.start_error == 0.0);
  RC_ASSERT(norm(rolled.motion.effectors[0][0] - reach.problem.goals[0].path.start) == 0.0);
  RC_ASSERT(measured.contact_slide <= kReachTolerance);
  RC_ASSERT(measured.contact_tilt <= kTiltTolerance);
}

RC_GTEST_PROP(RollOutProperty, FeetStandWhateverIsAsked, (std::uint64_t seed)) {
  const WildReach reach(seed);
  const Clip clip = roll_out(reach.problem, reach.parameters).motion.clip;
  const MeasuredMotion measured(reach.problem, clip);
  RC_ASSERT(measured.finite);
  RC_ASSERT(measured.contact_slide <= kReachTolerance);
  RC_ASSERT(measured.contact_tilt <= kTiltTolerance);
}

RC_GTEST_PROP(RollOutProperty, HandIsOnItsPathAtEveryFrameOrTheMotionSaysSo,
              (std::uint64_t seed, bool whole)) {
  const RandomReach reach(whole ? full() : half(), seed);
  const RolledOut rolled = roll_out(reach.problem, reach.parameters);
  const MeasuredMotion measured(reach.problem, rolled.motion.clip);
  RC_ASSERT(measured.path_error <= kReachTolerance * 1.001 || !rolled.outcome.met());
}

TEST(RollOut, HandIsOnItsPathButForFoldedElbows) {
  // typically within 0.06 mm; the trunk may carry the shoulder onto the hand's path, and the folded
  // arm there is singular
  constexpr int kTrials = 300;
  for (const PosedBody* body : {&half(), &full()}) {
    int on_path = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const RandomReach reach(*body, static_cast<std::uint64_t>(trial));
      const RolledOut rolled = roll_out(reach.problem, reach.parameters);
      const MeasuredMotion measured(reach.problem, rolled.motion.clip);
      EXPECT_LE(measured.goal_error, reach.problem.goal_tolerance * 1.001) << trial;
      if (measured.path_error <= 5e-4) ++on_path;
    }
    EXPECT_GE(on_path, kTrials * 99 / 100) << body->body.name();
  }
}

RC_GTEST_PROP(RollOutProperty, LockedJointsKeepTheirStartAngles, (std::uint64_t seed, bool whole)) {
  RandomReach reach(whole ? full() : half(), seed);
  for (std::size_t d = 0; d < reach.posed.body.dofs().size(); ++d) {
    reach.parameters.locked[d] = *rc::gen::inRange(0, 4) == 0;
  }
  const Clip clip = roll_out(reach.problem, reach.parameters).motion.clip;
  RC_ASSERT(reach.keeps_locked(clip));
}

RC_GTEST_PROP(RollOutProperty, ScalingAllWeightsChangesNothing, (std::uint64_t seed, bool whole)) {
  RandomReach reach(whole ? full() : half(), seed);
  const double factor = std::pow(10.0, *rc::gen::inRange(-40, 41) / 10.0);
  const std::vector<double> before = roll_out(reach.problem, reach.parameters).motion.clip.angles;
  for (std::size_t d = 0; d < reach.posed.body.dofs().size(); ++d)
    reach.parameters.values[d] *= factor;
  const std::vector<double> after = roll_out(reach.problem, reach.parameters).motion.clip.angles;
  for (std::size_t i = 0; i < before.size(); ++i) {
    RC_ASSERT(std::fabs(before[i] - after[i]) <= 1e-9);
  }
}

}  // namespace
}  // namespace shigusa
