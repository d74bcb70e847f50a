// SPDX-License-Identifier: MIT
#include "nlp/nlp_rollout.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "body/posture_modes.hpp"
#include "criteria/joint_range.hpp"
#include "dynamics/centre_of_mass.hpp"
#include "plan/held_input.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kLow{-0.1, 0.5, 0.5};

std::vector<double> angles_of(NlpRollout& rollout, const MotionInput<double>& input) {
  std::vector<double> angles;
  rollout.run(input, [&](const PlacedFrame<double>& frame) {
    angles.insert(angles.end(), frame.angles.begin(), frame.angles.end());
  });
  return angles;
}

// rad, largest excess of the clip's angles beyond their limits
double most_excess(const PosedBody& posed, const Clip& clip) {
  double excess = 0.0;
  for (int f = 0; f < clip.frames; ++f) {
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      const double angle = clip.frame(f)[static_cast<std::size_t>(d)];
      excess = std::fmax(excess, posed.body.dof(d).lower - angle);
      excess = std::fmax(excess, angle - upper_limit(posed, d, clip.frame(f)));
    }
  }
  return excess;
}

RC_GTEST_PROP(NlpRolloutProperty, HandIsOnItsPathAndFeetArePlanted,
              (std::uint64_t seed, bool whole)) {
  const RandomReach reach(whole ? full() : half(), seed);
  const RolledOut rolled = roll_out_nlp(reach.problem, reach.parameters);
  const MeasuredMotion measured(reach.problem, rolled.motion.clip);
  RC_ASSERT(measured.finite);
  RC_ASSERT(measured.start_error == 0.0);
  RC_ASSERT(measured.path_error <= kReachTolerance);
  RC_ASSERT(measured.contact_slide <= kReachTolerance);
  RC_ASSERT(measured.contact_tilt <= kTiltTolerance);
  RC_ASSERT(rolled.outcome.met());
  RC_ASSERT(most_excess(reach.posed, rolled.motion.clip) <= 0.0);
}

RC_GTEST_PROP(NlpRolloutProperty, FeetStandAndLimitsHoldWhateverIsAsked, (std::uint64_t seed)) {
  const WildReach reach(seed);
  const Clip clip = roll_out_nlp(reach.problem, reach.parameters).motion.clip;
  const MeasuredMotion measured(reach.problem, clip);
  RC_ASSERT(measured.finite);
  RC_ASSERT(measured.contact_slide <= kReachTolerance);
  RC_ASSERT(measured.contact_tilt <= kTiltTolerance);
  RC_ASSERT(measured.largest_step <= NlpIkSettings{}.max_change + 1e-9);
  RC_ASSERT(most_excess(full(), clip) <= 0.0);
}

RC_GTEST_PROP(NlpRolloutProperty, DrawnToAPostureTheHandIsStillOnItsPath,
              (std::uint64_t seed, bool whole)) {
  RandomReach reach(whole ? full() : half(), seed);
  Random random(seed, 1);
  pose(reach.posed, reach.parameters,
       [&](const PostureMode&) { return random.uniform(-0.5, 0.5); });
  value_of(reach.posed, reach.parameters, "delay") = random.uniform(0.0, kDelayMax);
  const Clip clip = roll_out_nlp(reach.problem, reach.parameters).motion.clip;
  const MeasuredMotion measured(reach.problem, clip);
  RC_ASSERT(measured.path_error <= kReachTolerance);
  RC_ASSERT(measured.contact_slide <= kReachTolerance);
  RC_ASSERT(measured.contact_tilt <= kTiltTolerance);
  RC_ASSERT(most_excess(reach.posed, clip) <= 0.0);
  reach.parameters.posed = false;
  RC_ASSERT(roll_out_nlp(reach.problem, reach.parameters).motion.clip.angles != clip.angles);
}

RC_GTEST_PROP(NlpRolloutProperty, OutcomeIsWhatTheMotionDoes, (std::uint64_t seed)) {
  Random random(seed);
  const Vec3d goal{random.uniform(-1.0, 1.0), random.uniform(0.0, 2.0), random.uniform(0.0, 1.0)};
  const ReachProblem problem = reach_with(full(), "right_hand", goal);
  const RolledOut rolled = roll_out_nlp(problem, random_parameters(full(), random));
  const MeasuredMotion measured(problem, rolled.motion.clip);
  RC_ASSERT(std::fabs(rolled.outcome.path_error - measured.path_error) <= 1e-12);
  RC_ASSERT(std::fabs(rolled.outcome.goal_error - measured.goal_error) <= 1e-12);
  // 2 sin(θ / 2) instead of the angle: θ³ / 24 less
  RC_ASSERT(std::fabs(rolled.outcome.contact_tilt - measured.contact_tilt) <= 1e-10);
  RC_ASSERT(rolled.outcome.contact_slide <= measured.contact_slide + 1e-12);
}

RC_GTEST_PROP(NlpRolloutProperty, LockedJointsKeepTheirStartAngles,
              (std::uint64_t seed, bool whole)) {
  RandomReach reach(whole ? full() : half(), seed);
  for (std::size_t d = 0; d < reach.posed.body.dofs().size(); ++d) {
    reach.parameters.locked[d] = *rc::gen::inRange(0, 4) == 0;
  }
  const Clip clip = roll_out_nlp(reach.problem, reach.parameters).motion.clip;
  RC_ASSERT(reach.keeps_locked(clip));
}

RC_GTEST_PROP(NlpRolloutProperty, ScalingAllWeightsByAPowerOfTwoChangesNoByte,
              (std::uint64_t seed, bool whole)) {
  RandomReach reach(whole ? full() : half(), seed);
  const std::vector<double> before =
      roll_out_nlp(reach.problem, reach.parameters).motion.clip.angles;
  for (std::size_t d = 0; d < reach.posed.body.dofs().size(); ++d) {
    reach.parameters.values[d] *= 0x1p-7;
  }
  RC_ASSERT(roll_out_nlp(reach.problem, reach.parameters).motion.clip.angles == before);
}

// The half body with practically no limits.
PosedBody boundless_body() {
  BodyDefinition definition = half().body.definition();
  definition.couplings.clear();
  for (Dof& dof : definition.dofs) {
    dof.lower = -100.0;
    dof.upper = 100.0;
  }
  return {BodyModel(std::move(definition)), half().home};
}

RC_GTEST_PROP(NlpRolloutProperty, WithoutLimitsAndInShortStepsItIsTheMotionOfWeightedIk,
              (std::uint64_t seed)) {
  // both take the least weighted step along the path, and differ by the curvature of arcs within a
  // step
  static const PosedBody posed = boundless_body();
  RandomReach reach(posed, seed);
  const auto difference = [&](int steps) {
    reach.problem.steps = steps;
    const Clip nlp = roll_out_nlp(reach.problem, reach.parameters).motion.clip;
    const Clip ik = roll_out(reach.problem, reach.parameters).motion.clip;
    double largest = 0.0;
    for (std::size_t i = 0; i < nlp.angles.size(); ++i) {
      largest = std::fmax(largest, std::fabs(nlp.angles[i] - ik.angles[i]));
    }
    return largest;
  };
  const double coarse = difference(60);
  RC_ASSERT(coarse <= 0.2);
  // errors of the first order in the steps, which become a quarter
  RC_ASSERT(difference(240) <= 0.35 * coarse + 1e-4);
}

TEST(NlpRollout, UsedAgainGivesTheSameMotion) {
  const ReachProblem problem = reach_with(full(), "right_hand", {-0.6, 1.9, -0.4});
  Random random(82);
  const std::vector<double> first = inverse_weights(full(), random_parameters(full(), random));
  const std::vector<double> second = inverse_weights(full(), random_parameters(full(), random));
  NlpRollout rollout(problem);
  const std::vector<double> before = angles_of(rollout, first);
  (void)angles_of(rollout, second);
  EXPECT_EQ(angles_of(rollout, first), before);
  NlpRollout other(problem);
  EXPECT_EQ(angles_of(other, first), before);
}

TEST(NlpRollout, ReachingForWhereTheHandIsMovesNothing) {
  const Vec3d here = effector_position(full(), full().home.angles, "right_hand");
  const ReachProblem problem = reach_with(full(), "right_hand", here);
  const RolledOut rolled = roll_out_nlp(problem, uniform_parameters(full()));
  EXPECT_LT(MeasuredMotion(problem, rolled.motion.clip).largest_step, 1e-12);
}

TEST(NlpRollout, FramesSayHowTheBodyMovesThere) {
  // seen from the angles alone, by the functions that have tests of their own
  const ReachProblem problem = reach_with(full(), "right_hand", kLow);
  const RolledOut rolled = roll_out_nlp(problem, uniform_parameters(full()));
  const Motion& motion = rolled.motion;
  const std::size_t dofs = full().body.dofs().size();
  DynamicsWorkspace<double> work(full());
  std::vector<double> speeds(dofs);
  std::vector<double> accelerations(dofs);
  std::vector<double> torques(dofs);
  for (int f = 0; f <= 60; ++f) {
    const std::span<const double> before = motion.clip.frame(f == 0 ? 0 : f - 1);
    const std::span<const double> now = motion.clip.frame(f);
    const std::span<const double> after = motion.clip.frame(f == 60 ? 60 : f + 1);
    for (std::size_t d = 0; d < dofs; ++d) {
      speeds[d] = (after[d] - before[d]) * 30.0;
      accelerations[d] = (after[d] - 2.0 * now[d] + before[d]) * 3600.0;
    }
    const Kinematics<double> kinematics = placed(full(), now);
    const Wrench<double> ground =
        inverse_dynamics<double>(full(), kinematics, {speeds, accelerations}, work, torques);
    share_ground_wrench<double>(full(), kinematics, {}, ground, torques);
    const auto k = static_cast<std::size_t>(f);
    for (std::size_t d = 0; d < dofs; ++d) {
      EXPECT_NEAR(motion.torques[k * dofs + d], torques[d], 1e-7) << f << ' ' << d;
    }
    EXPECT_LT(norm(motion.centre_of_mass[k] - centre_of_mass(full(), kinematics)), 1e-12);
    EXPECT_EQ(motion.effectors[0][k], effector_position(full(), now, "right_hand"));
  }
}

TEST(NlpRollout, EndsInItsGuideWhereThatArrives) {
  const ReachProblem plain = reach_with(half(), "right_hand", kLow);
  Random random(83);
  const Motion other = roll_out_nlp(plain, random_parameters(half(), random)).motion;
  ReachProblem guided = plain;
  guided.guide.assign(other.clip.frame(60).begin(), other.clip.frame(60).end());
  for (const bool follow_path : {true, false}) {
    guided.follow_path = follow_path;
    const RolledOut rolled = roll_out_nlp(guided, uniform_parameters(half()));
    EXPECT_TRUE(rolled.outcome.met());
    for (std::size_t d = 0; d < 9; ++d) {
      // at a limit a share of the room is left
      EXPECT_NEAR(rolled.motion.clip.frame(60)[d], guided.guide[d], radians(0.5)) << d;
    }
    const double off_path = MeasuredMotion(guided, rolled.motion.clip).path_error;
    EXPECT_EQ(off_path > kReachTolerance, !follow_path);
  }
}

TEST(NlpRollout, APostureChangesAfterItsDelayAndThePathBows) {
  ReachProblem problem = reach_with(half(), "right_hand", kLow);
  problem.goals[0].bow = {0.1, 0, 0};
  problem.goals[0].sway = {0, 0, 0.1};
  const std::vector<double> weights(9, 1.0);
  std::vector<double> change(9, 0.0);
  const auto knee = static_cast<std::size_t>(half().body.find_dof("right_knee.flexion").value());
  change[knee] = 0.5;
  NlpRollout rollout(problem);
  const std::vector<double> plain = angles_of(rollout, weights);
  const MotionInput<double> input(weights, change,
                                  {.delay = 0.4, .bow = 1.0, .skew = 0.3, .sway = 0.5});
  const std::vector<double> drawn = angles_of(rollout, input);
  EXPECT_GT(drawn[60 * 9 + knee], plain[60 * 9 + knee] + 0.1);
  const EffectorPath& path = problem.goals[0].path;
  for (int f = 0; f <= 60; ++f) {
    const double tau = f / 60.0;
    const Vec3d bowed = path.at(tau) + Vec3d{0.1, 0, 0} * path_bow(minimum_jerk(tau), 0.3) +
                        Vec3d{0, 0, 0.05} * path_bow(minimum_jerk(tau), 0.0);
    const auto posture = std::span(drawn).subspan(static_cast<std::size_t>(f) * 9, 9);
    EXPECT_LT(norm(effector_position(half(), posture, "right_hand") - bowed), kReachTolerance);
  }
  // before the delay is over the posture is not drawn: as with no change at all
  const std::vector<double> no_change(9, 0.0);
  const MotionInput<double> calm(weights, no_change, input.timing);
  const std::vector<double> undrawn = angles_of(rollout, calm);
  for (std::size_t i = 0; i < 24 * 9; ++i) EXPECT_EQ(drawn[i], undrawn[i]);
}

TEST(NlpRollout, BeyondReachItComesNearAndNeitherShakesNorBreaksApart) {
  for (const PosedBody* posed : {&half(), &full()}) {
    const ReachProblem problem = reach_with(*posed, "right_hand", {-3.0, 4.0, 5.0});
    const RolledOut rolled = roll_out_nlp(problem, uniform_parameters(*posed));
    const MeasuredMotion measured(problem, rolled.motion.clip);
    EXPECT_TRUE(measured.finite);
    EXPECT_FALSE(rolled.outcome.met());
    EXPECT_LE(measured.largest_step, NlpIkSettings{}.max_change + 1e-9);
    const Vec3d shoulder{0, 1.4, 0};
    EXPECT_LT(measured.goal_error, norm(problem.goals[0].path.goal - shoulder) - 0.3);
  }
}

TEST(NlpRollout, AGoalThatIsNoNumberIsNotMet) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const RolledOut rolled =
      roll_out_nlp(reach_with(full(), "right_hand", {nan, 1.0, 0.5}), uniform_parameters(full()));
  EXPECT_FALSE(rolled.outcome.met());
  for (const double angle : rolled.motion.clip.angles) EXPECT_TRUE(std::isfinite(angle));
}

TEST(NlpRollout, RefusesBrokenProblemsAndInputs) {
  ReachProblem problem = reach_with(half(), "right_hand", kLow);
  const auto refused = [&](auto change) {
    ReachProblem broken = problem;
    change(broken);
    EXPECT_THROW(NlpRollout{broken}, PreconditionError);
  };
  refused([](ReachProblem& p) { p.steps = 0; });
  refused([](ReachProblem& p) { p.duration = 0.0; });
  refused([](ReachProblem& p) { p.guide = {0.0}; });
  refused([](ReachProblem& p) { p.supports.resize(1); });
  EXPECT_THROW(NlpRollout(problem, {.damping = -1.0}), PreconditionError);
  NlpRollout rollout(problem);
  const std::vector<double> weights(9, 1.0);
  const std::vector<double> short_change(3, 0.0);
  EXPECT_THROW(angles_of(rollout, std::vector<double>(8, 1.0)), PreconditionError);
  EXPECT_THROW(angles_of(rollout, {weights, short_change, {}}), PreconditionError);
}

}  // namespace
}  // namespace shigusa
