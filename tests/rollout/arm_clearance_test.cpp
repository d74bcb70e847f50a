// SPDX-License-Identifier: MIT
#include "rollout/arm_clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "rollout/rollout.hpp"
#include "simd/pack.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// The human whose parts of that name have another radius (m) at the end.
PosedBody with_part(const std::string& name, double radius, double to_radius) {
  BodyDefinition body = human_body().body.definition();
  for (Capsule& capsule : body.capsules) {
    if (capsule.name != name) continue;
    capsule.radius = radius;
    capsule.to_radius = to_radius;
  }
  return {BodyModel(body), human_body().home};
}

Clip reached(const PosedBody& posed, const Vec3d& goal) {
  ReachProblem problem = reach_with(posed, "right_hand", goal);
  problem.hold_limits = problem.posture_law = true;
  problem.context.gaze = goal;
  return roll_out(problem, uniform_parameters(posed)).motion.clip;
}

const Effector& left_hand(const PosedBody& posed) {
  return posed.body.effector(posed.body.find_effector("left_hand").value());
}

// The largest increase (m) of the left arm's depth in the body over its start, in any frame.
double deepest_left(const PosedBody& posed, const Clip& clip) {
  const auto pairs =
      allowed_as_at(home_kinematics(posed), posed, limb_pairs(posed, left_hand(posed)));
  double most = -1.0;
  for (int f = 0; f < clip.frames; ++f) {
    most = std::max(most, deepest_of(posed, placed(posed, clip.frame(f)), pairs).depth);
  }
  return most;
}

TEST(ArmClearance, AFreeArmGoesAsideOfThighsAndTrunk) {
  const PosedBody posed = human_body();
  // it would be 13 cm in
  EXPECT_LT(deepest_left(posed, reached(posed, {-0.6, 0.2, -0.1})), 0.0);
}

TEST(ArmClearance, AnArmThatIsClearMovesAsIfNothingWereThere) {
  const PosedBody posed = human_body();
  BodyDefinition bare = posed.body.definition();
  bare.capsules.clear();
  const Vec3d goal{-0.3, 1.3, 0.4};
  const Clip clip = reached(posed, goal);
  ASSERT_LT(deepest_left(posed, clip), -kArmKeepsOff);
  EXPECT_EQ(clip.angles, reached({BodyModel(bare), posed.home}, goal).angles);
}

// The body with its left arm abducted by an angle (rad) from its start.
Kinematics<double> abducted(const PosedBody& posed, double angle) {
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  angles[static_cast<std::size_t>(posed.body.find_dof("left_shoulder.abduction").value())] += angle;
  return placed(posed, angles);
}

// The smallest angle (rad) by which the arm has to move aside from there.
double aside(const PosedBody& posed, double angle) {
  const int abduction = posed.body.find_dof("left_shoulder.abduction").value();
  return ArmClearance<double>(reach_with(posed, "right_hand", {-0.3, 1.0, 0.4}), left_hand(posed),
                              abduction)
      .aside(abducted(posed, angle));
}

TEST(ArmClearance, WhatIsNearAsTheBodyStartsMayStayAsNear) {
  // some 4 cm within each other
  const PosedBody posed = with_part("left_thigh", 0.2, 0.2);
  EXPECT_NEAR(aside(posed, 0.0), 0.0, 1e-9);
  EXPECT_LT(aside(posed, 0.1), -0.05);
}

TEST(ArmClearance, TellsHowFarTheArmMustGoAside) {
  // beside a cone
  const PosedBody posed = with_part("left_thigh", 0.02, 0.16);
  const auto depth_at = [&](double angle) {
    return limb_penetration(posed, abducted(posed, angle), left_hand(posed)).depth;
  };
  ASSERT_LT(depth_at(0.0), -kArmKeepsOff);
  double angle = -0.3;
  EXPECT_GT(depth_at(angle), 0.0);
  for (int step = 0; step < 8; ++step) angle += aside(posed, angle);
  EXPECT_NEAR(depth_at(angle), -kArmKeepsOff, 1e-4);
}

TEST(ArmClearance, EachLaneIsAsItIsAlone) {
  using Lane = Pack<float, 1>;
  using Lanes = Pack<float, 4>;
  const PosedBody posed = human_body();
  const int abduction = posed.body.find_dof("left_shoulder.abduction").value();
  ArmClearance<Lanes> together(reach_with(posed, "right_hand", {-0.3, 1.0, 0.4}), left_hand(posed),
                               abduction);
  ArmClearance<Lane> alone(reach_with(posed, "right_hand", {-0.3, 1.0, 0.4}), left_hand(posed),
                           abduction);
  Kinematics<Lanes> lanes(posed);
  Kinematics<Lane> one(posed);
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    std::vector<Lanes> angles;
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      const Dof& dof = posed.body.dof(d);
      Lanes& angle = angles.emplace_back();
      for (int lane = 0; lane < 4; ++lane) {
        angle.set(lane, static_cast<float>(random.uniform(dof.lower, dof.upper)));
      }
    }
    forward_kinematics<Lanes>(posed, angles, lanes);
    const Lanes found = together.aside(lanes);
    for (int lane = 0; lane < 4; ++lane) {
      std::vector<Lane> own;
      for (const Lanes& angle : angles) own.emplace_back(angle[lane]);
      forward_kinematics<Lane>(posed, own, one);
      EXPECT_EQ(found[lane], alone.aside(one)[0]) << round << ' ' << lane;
    }
  }
}

}  // namespace
}  // namespace shigusa
