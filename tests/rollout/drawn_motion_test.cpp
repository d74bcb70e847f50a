// SPDX-License-Identifier: MIT
// Motions drawn to a posture, on bowed paths.
#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "body/posture_modes.hpp"
#include "plan/held_input.hpp"
#include "support/lanes.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr Vec3d kLow{-0.2, 0.5, 0.5};

Parameters drawn(const PosedBody& posed, const std::string& mode, double value) {
  Parameters parameters = uniform_parameters(posed);
  pose(posed, parameters,
       [&](const PostureMode& known) { return known.name == mode ? value : 0.0; });
  return parameters;
}

double final_angle(const PosedBody& posed, const RolledOut& rolled, const char* dof) {
  const Clip& clip = rolled.motion.clip;
  return clip.frame(clip.frames - 1)[static_cast<std::size_t>(posed.body.find_dof(dof).value())];
}

TEST(DrawnMotion, SquatBendsTheKneesByAsMuchMoreAndGoalsAreMetAllTheSame) {
  const PosedBody posed = full_body();
  const ReachProblem problem = reach_with(posed, "right_hand", kLow);
  double before = -1.0;
  for (const double squat : {0.0, 30.0, 60.0, 90.0}) {
    const RolledOut rolled = roll_out(problem, drawn(posed, "squat", radians(squat)));
    EXPECT_TRUE(rolled.outcome.met()) << squat;
    const double knee = degrees(final_angle(posed, rolled, "right_knee.flexion") +
                                final_angle(posed, rolled, "left_knee.flexion")) /
                        2.0;
    EXPECT_GT(knee, before + 15.0) << squat;
    before = knee;
  }
}

TEST(DrawnMotion, WithoutAValueIsThePlainMotion) {
  const PosedBody posed = half_body();
  const ReachProblem problem = reach_with(posed, "right_hand", kLow);
  const Clip plain = roll_out(problem, uniform_parameters(posed)).motion.clip;
  const Clip drawn_nowhere = roll_out(problem, drawn(posed, "", 0.0)).motion.clip;
  for (std::size_t k = 0; k < plain.angles.size(); ++k) {
    EXPECT_NEAR(plain.angles[k], drawn_nowhere.angles[k], 1e-12);
  }
}

TEST(DrawnMotion, DelayKeepsThePostureBackAtFirst) {
  const PosedBody posed = full_body();
  ReachProblem problem =
      reach_with(posed, "left_hand", effector_position(posed, posed.home.angles, "left_hand"));
  Parameters parameters = drawn(posed, "squat", radians(60.0));
  value_of(posed, parameters, "delay") = 0.5;
  const Clip late = roll_out(problem, parameters).motion.clip;
  const auto knee = static_cast<std::size_t>(posed.body.find_dof("right_knee.flexion").value());
  EXPECT_NEAR(late.frame(30)[knee], late.frame(0)[knee], 1e-9);
  EXPECT_GT(late.frame(60)[knee], late.frame(0)[knee] + radians(30.0));
}

TEST(DrawnMotion, BowTakesTheHandOffItsLineByThatMuch) {
  const PosedBody posed = full_body();
  ReachProblem problem = reach_with(posed, "right_hand", {-0.25, 1.3, 0.3});
  const EffectorPath& path = problem.goals[0].path;
  problem.goals[0].bow = {0.0, 0.0, norm(path.goal - path.start)};
  Parameters parameters = drawn(posed, "", 0.0);
  value_of(posed, parameters, "bow") = 0.1;
  const RolledOut rolled = roll_out(problem, parameters);
  ASSERT_TRUE(rolled.outcome.met());
  double farthest = 0.0;
  const std::vector<Vec3d>& hand = rolled.motion.effectors[0];
  for (int f = 0; f < problem.steps + 1; ++f) {
    const Vec3d off =
        hand[static_cast<std::size_t>(f)] - path.at(static_cast<double>(f) / problem.steps);
    farthest = max(farthest, off.z);
    EXPECT_LT(abs(off.x) + abs(off.y), 2e-3);
  }
  EXPECT_NEAR(farthest, 0.1 * problem.goals[0].bow.z, 1e-3);
}

TEST(DrawnMotion, SwayTakesTheHandAsideByThatMuch) {
  const PosedBody posed = full_body();
  ReachProblem problem = reach_with(posed, "right_hand", {-0.25, 1.3, 0.3});
  problem.goals[0].sway = {-0.5, 0.0, 0.0};
  Parameters parameters = drawn(posed, "", 0.0);
  value_of(posed, parameters, "sway") = 0.1;
  const RolledOut rolled = roll_out(problem, parameters);
  ASSERT_TRUE(rolled.outcome.met());
  const EffectorPath& path = problem.goals[0].path;
  double farthest = 0.0;
  for (int f = 0; f <= problem.steps; ++f) {
    const Vec3d off = rolled.motion.effectors[0][static_cast<std::size_t>(f)] -
                      path.at(static_cast<double>(f) / problem.steps);
    farthest = max(farthest, -off.x);
  }
  EXPECT_NEAR(farthest, 0.05, 1e-3);
}

TEST(DrawnMotion, SkewBringsTheBowForward) {
  EXPECT_EQ(path_bow(0.0, 0.5), 0.0);
  EXPECT_EQ(path_bow(1.0, 0.5), 0.0);
  EXPECT_EQ(path_bow(0.5, 0.7), 1.0);
  EXPECT_GT(path_bow(0.25, 0.5), path_bow(0.75, 0.5));
  EXPECT_LT(path_bow(0.25, -0.5), path_bow(0.75, -0.5));
}

TEST(DrawnMotion, LanesScoreAsDoubleDoes) {
  const PosedBody posed = full_body();
  ReachProblem problem = reach_with(posed, "right_hand", kLow);
  problem.hold_limits = true;
  problem.goals[0].bow = {0.0, 0.3, 0.0};
  problem.goals[0].sway = {-0.3, 0.0, 0.0};
  const CriteriaSettings criteria = default_criteria();
  Random random(3);
  std::vector<float> weights;
  std::vector<float> changes;
  std::vector<float> timing;
  PlayedMotions played;
  for (int i = 0; i < 37; ++i) {
    Parameters parameters = random_parameters(posed, random);
    pose(posed, parameters,
         [&](const PostureMode& mode) { return 0.5 * random.uniform(mode.lower, mode.upper); });
    value_of(posed, parameters, "delay") = random.uniform(0.0, 0.4);
    value_of(posed, parameters, "bow") = random.uniform(-0.1, 0.2);
    value_of(posed, parameters, "skew") = random.uniform(-1.0, 1.0);
    value_of(posed, parameters, "sway") = random.uniform(-0.2, 0.2);
    for (const double w : inverse_weights(posed, parameters))
      weights.push_back(static_cast<float>(w));
    for (const double c : posture_change(posed, modes_of(posed, parameters))) {
      changes.push_back(static_cast<float>(c));
    }
    for (const double t : list_of(posed).of_kind(ParameterKind::timing, parameters)) {
      timing.push_back(static_cast<float>(t));
    }
    played.add(problem, parameters, criteria);
  }
  expect_lanes_like(played, problem, criteria, {weights, changes, timing});
}

}  // namespace
}  // namespace shigusa
