// SPDX-License-Identifier: MIT
#include "rollout/hand_supports.hpp"

#include <gtest/gtest.h>

#include <shigusa/request.hpp>

#include "body/posture_modes.hpp"
#include "plan/held_input.hpp"
#include "problem/make_problem.hpp"
#include "rollout/batch_rollout.hpp"
#include "rollout/rollout.hpp"
#include "support/named_values.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// A reach to the floor by the right hand with the left one on its thigh.
class OnTheThigh : public testing::Test {
 protected:
  static Task asked() {
    Task task(human_body());
    task.goals = {{"right_hand", {-0.1, 0.15, 0.4}}};
    task.supports = {{"left_hand", "thigh"}};
    return task;
  }

  // The lean and the knees of a person who picks something up.
  Parameters bent(double share) const {
    Parameters parameters = uniform_parameters(task.body);
    pose(task, parameters, [](const PostureMode& mode) {
      return mode.name == "squat" ? radians(60) : mode.name == "lean" ? radians(50) : 0.0;
    });
    parameters.values.push_back(share);
    parameters.locked.push_back(false);
    return parameters;
  }

  // How far the hand is from its place in a frame (m).
  [[nodiscard]] double off(const Clip& clip, int frame) const {
    const Kinematics<double> k = placed(task.body, clip.frame(frame));
    const HandSupport& support = problem.supports[0];
    const Effector& hand = task.body.effector(support.effector);
    return norm(k.point(hand.link, hand.point) - k.point(support.carrier, support.place));
  }

  const Task task = asked();
  const ReachProblem problem = make_problem(task).value();
};

TEST_F(OnTheThigh, AHandIsAnExactConstraintFromItsArrivalOn) {
  const Constraint<double> hand = constraints(problem).back();
  const HandSupport& support = problem.supports[0];
  EXPECT_EQ(hand.link, task.body.effector(support.effector).link);
  EXPECT_EQ(hand.carrier, support.carrier);
  EXPECT_EQ(hand.place, support.place);
  EXPECT_TRUE(hand.exact && !hand.turns());
  EXPECT_FALSE(hand.holds_at(support.arrives - 0.01));
  EXPECT_TRUE(hand.holds_at(support.arrives) && hand.holds_at(1.0));
}

TEST_F(OnTheThigh, AHandArrivesAndStays) {
  const RolledOut rolled = roll_out(problem, bent(0.1));
  ASSERT_TRUE(rolled.outcome.met());
  EXPECT_GT(off(rolled.motion.clip, 0), 0.1);
  for (int f = 0; f <= problem.steps; ++f) {
    if (f < problem.supports[0].arrives * problem.steps) continue;
    EXPECT_LE(off(rolled.motion.clip, f), kReachTolerance) << f;
  }
}

// The place at 0.65 of a thigh whose knee is thicker by 0.1 m.
TEST_F(OnTheThigh, AHandRestsOnTheSkinOfAThighThatTapers) {
  BodyDefinition body = task.body.definition();
  for (Capsule& capsule : body.capsules) {
    if (capsule.name == "left_thigh") capsule.to_radius += 0.1;
  }
  Task tapered({BodyModel{body}, task.home});
  tapered.goals = task.goals;
  tapered.supports = task.supports;
  const HandSupport& support = problem.supports[0];
  const Vec3d out = make_problem(tapered).value().supports[0].place - support.place;
  EXPECT_NEAR(dot(out, support.normal), 0.065, 1e-9);
}

TEST_F(OnTheThigh, AHandMovesWithoutAJolt) {
  const Clip clip = roll_out(problem, bent(0.1)).motion.clip;
  std::vector<double> way;
  for (int f = 0; f < clip.frames; ++f) way.push_back(off(clip, f));
  for (std::size_t f = 2; f < way.size(); ++f) {
    // of a way of 0.35 m in 42 frames a smooth profile takes at most 8 d / n² a square of frames
    EXPECT_LT(std::fabs(way[f] - 2 * way[f - 1] + way[f - 2]), 8 * 0.35 / (42.0 * 42.0)) << f;
  }
}

TEST_F(OnTheThigh, WhatAHandPressesWithChangesNoAngle) {
  const Motion touching = roll_out(problem, bent(0.0)).motion;
  const Motion pressing = roll_out(problem, bent(0.15)).motion;
  EXPECT_EQ(touching.clip.angles, pressing.clip.angles);
  const auto frames = static_cast<std::size_t>(pressing.clip.frames);
  const double weight = task.body.mass() * kGravity;
  EXPECT_NEAR(norm(pressing.resting[0].forces[frames - 1]), 0.15 * weight, 1e-9 * weight);
  EXPECT_EQ(norm(pressing.resting[0].forces[frames / 2]), 0.0);
  EXPECT_EQ(norm(touching.resting[0].forces[frames - 1]), 0.0);
}

TEST_F(OnTheThigh, PressingTakesItsLeverOffTheLowBack) {
  const Motion touching = roll_out(problem, bent(0.0)).motion;
  const Motion pressing = roll_out(problem, bent(0.1)).motion;
  const auto last = static_cast<std::size_t>(touching.clip.frames - 1);
  const auto back = static_cast<std::size_t>(task.body.find_dof("spine.flexion").value());
  const std::size_t k = last * task.body.dofs().size() + back;
  const Kinematics<double> end = placed(task.body, touching.clip.frame(static_cast<int>(last)));
  const RestingHand& hand = pressing.resting[0];
  const Vec3d moment = cross(hand.places[last] - end.origin[back], hand.forces[last]);
  EXPECT_LT(touching.torques[k], -50.0);
  EXPECT_NEAR(pressing.torques[k] - touching.torques[k], -dot(end.axis[back], moment), 1e-9);
  EXPECT_GT(pressing.torques[k] - touching.torques[k], 10.0);
}

TEST_F(OnTheThigh, AFreeHandMovesAsWithoutSupport) {
  ReachProblem without = problem;
  without.supports.clear();
  Parameters plain = bent(0.0);
  plain.values.pop_back();
  const Clip free = roll_out(problem, bent(-0.01)).motion.clip;
  const Clip alone = roll_out(without, plain).motion.clip;
  // rows of zeros are in the sums, and 0 is added to them
  double most = 0.0;
  for (std::size_t k = 0; k < free.angles.size(); ++k) {
    most = std::fmax(most, std::fabs(free.angles[k] - alone.angles[k]));
  }
  EXPECT_LT(most, 1e-9);
}

TEST_F(OnTheThigh, LanesScoreAsDoubleDoesWithHandsFreeInSome) {
  CriteriaSettings criteria = default_criteria();
  criteria[CriterionKind::jolts].weight =
      0.0;  // of the fourth power of a difference: of little use in comparisons
  std::vector<double> shares{0.0, -0.02, 0.1, 0.2, -0.05};
  std::vector<float> weights;
  std::vector<float> postures;
  std::vector<float> timing;
  std::vector<float> supports;
  std::vector<double> expected;
  for (const double share : shares) {
    const Parameters parameters = bent(share);
    for (const double w : inverse_weights(task.body, parameters))
      weights.push_back(static_cast<float>(w));
    for (const double c : posture_change(task.body, modes_of(task, parameters))) {
      postures.push_back(static_cast<float>(c));
    }
    timing.insert(timing.end(), kTimings, 0.0F);
    supports.push_back(static_cast<float>(share));
    const RolledOut rolled = roll_out(problem, parameters);
    ASSERT_TRUE(rolled.outcome.met());
    expected.push_back(score_motion(task.body, rolled.motion, criteria, problem.context).total);
  }
  MotionInputs inputs{weights, postures, timing};
  inputs.supports = supports;
  std::vector<double> scores(shares.size());
  BatchRollout(problem, criteria).score(inputs, scores);
  // single precision over 60 frames
  for (std::size_t i = 0; i < scores.size(); ++i) EXPECT_NEAR(scores[i], expected[i], 0.02) << i;
}

}  // namespace
}  // namespace shigusa
