// SPDX-License-Identifier: MIT
#include "problem/reachability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/penetration.hpp"
#include "rollout/detour.hpp"
#include "support/problems.hpp"
#include "support/reach_bounds.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

ClosestReach closest(const PosedBody& posed, const Vec3d& goal) {
  return closest_reach(reach_with(posed, "right_hand", goal));
}

Vec3d random_point(Random& random) {
  return {random.uniform(-2.0, 2.0), random.uniform(-0.5, 2.5), random.uniform(-2.0, 2.0)};
}

// Distances less than 5 mm apart count as equal in the choice among descents, and a descent ends
// within 0.1 mm of its limit.
constexpr double kSlack = 5.1e-3;

TEST(ClosestReach, OfTheHalfBodyIsItsClosedForm) {
  Random random(91);
  for (int trial = 0; trial < 500; ++trial) {
    const Vec3d goal = random_point(random);
    const double expected = half_body_distance(half(), goal);
    const ClosestReach reach = closest(half(), goal);
    ASSERT_NEAR(reach.distance, expected, expected == 0.0 ? kReachTolerance : kSlack);
    ASSERT_EQ(reach.reached(), expected <= kReachTolerance);
  }
}

TEST(ClosestReach, TellsTheTwoSidesOfTheEdgeApart) {
  // 2 cm either side of the edge, in all directions from the middle of the body
  Random random(92);
  for (int trial = 0; trial < 300; ++trial) {
    const Vec3d goal = half_body_edge(half(), random_direction(random));
    const Vec3d outwards = normalized(goal - kMiddleOfTheBody);
    const double off = random.uniform(0.002, 0.02);
    ASSERT_TRUE(closest(half(), goal - outwards * off).reached());
    ASSERT_FALSE(closest(half(), goal + outwards * off).reached());
  }
}

TEST(ClosestReach, NeverBeatsTheStretchedChain) {
  Random random(93);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3d goal = random_point(random);
    ASSERT_GE(closest(full(), goal).distance, stretched_distance(full(), goal) - 1e-9);
  }
}

TEST(ClosestReach, FarAwayLeavesWhatTheStretchedChainLeaves) {
  // straight ahead and up, all joints can line up with the goal
  const Vec3d ahead = half().body.base().translation + Vec3d{0, 30.0, 40.0};
  EXPECT_NEAR(closest(half(), ahead).distance, half_body_distance(half(), ahead), 1e-3);
  EXPECT_NEAR(half_body_distance(half(), ahead), 50.0 - 1.9, 0.2);
}

TEST(ClosestReach, FindsEveryPlaceThatAMotionEndedAt) {
  Random random(94);
  for (int trial = 0; trial < 100; ++trial) {
    const ReachProblem problem = reach_with(full(), "right_hand", near_goal(full(), random));
    const RolledOut rolled = roll_out(problem, random_parameters(full(), random));
    ASSERT_TRUE(closest(full(), rolled.motion.effectors[0].back()).reached());
  }
}

TEST(ClosestReach, KeepsThePlantedFootWhereItIs) {
  Random random(95);
  for (int trial = 0; trial < 100; ++trial) {
    const ReachProblem problem = reach_with(full(), "right_hand", random_point(random));
    const ClosestReach reach = closest_reach(problem);
    Clip clip{.dofs = full().body.dof_count(), .frames = 1, .angles = reach.angles};
    const MeasuredMotion measured(problem, clip);
    ASSERT_LT(measured.contact_slide, 2e-5);
    ASSERT_LT(measured.contact_tilt, 2e-4);
    ASSERT_TRUE(measured.finite);
  }
}

TEST(ClosestReach, TellsWhereTheEffectorsAre) {
  ReachProblem problem = reach_with(full(), "right_hand", {-1.5, 1.0, 1.0});
  problem.goals.push_back(reach_with(full(), "left_hand", {1.5, 1.0, 1.0}).goals[0]);
  const ClosestReach reach = closest_reach(problem);
  ASSERT_EQ(reach.positions.size(), 2u);
  EXPECT_EQ(reach.positions[0], effector_position(full(), reach.angles, "right_hand"));
  EXPECT_EQ(reach.positions[1], effector_position(full(), reach.angles, "left_hand"));
  const Vec3d a = problem.goals[0].path.goal - reach.positions[0];
  const Vec3d b = problem.goals[1].path.goal - reach.positions[1];
  EXPECT_NEAR(reach.distance, std::sqrt(dot(a, a) + dot(b, b)), 1e-12);
}

TEST(ClosestReach, LeavesIdleLimbsAlone) {
  // a goal out of reach takes the best of many random postures: the left arm is not part of it
  Random random(96);
  for (int trial = 0; trial < 60; ++trial) {
    const Vec3d goal{random.uniform(-1.6, -1.0), random.uniform(0.0, 2.2),
                     random.uniform(-1.2, 1.2)};
    const ClosestReach reach = closest(full(), goal);
    for (int d = 0; d < full().body.dof_count(); ++d) {
      const Dof& dof = full().body.dof(d);
      if (dof.joint != "left_shoulder" && dof.joint != "left_elbow") continue;
      const auto k = static_cast<std::size_t>(d);
      ASSERT_EQ(reach.angles[k], full().home.angles[k]) << dof.name;
    }
  }
}

TEST(ClosestReach, IsTheSameEveryTime) {
  const Vec3d goal{-1.3, 1.6, 0.9};
  const ClosestReach first = closest(full(), goal);
  const ClosestReach second = closest(full(), goal);
  EXPECT_EQ(first.angles, second.angles);
  EXPECT_EQ(first.distance, second.distance);
}

TEST(ClosestReach, AtTheStartIsTheStartPosture) {
  const Vec3d here = effector_position(full(), full().home.angles, "right_hand");
  const ClosestReach reach = closest(full(), here);
  EXPECT_TRUE(std::equal(reach.angles.begin(), reach.angles.end(), full().home.angles.begin()));
  EXPECT_EQ(reach.distance, 0.0);
}

// The full body with a head as broad as its shoulders.
PosedBody with_big_head() {
  BodyDefinition body = full().body.definition();
  for (Capsule& capsule : body.capsules) {
    if (capsule.name == "head") capsule.radius = capsule.to_radius = 0.25;
  }
  return {BodyModel{body}, full().home};
}

double depth_at(const PosedBody& posed, const std::vector<double>& angles) {
  const Effector& hand = posed.body.effector(posed.body.find_effector("right_hand").value());
  Kinematics<double> kinematics(posed);
  forward_kinematics<double>(posed, angles, kinematics);
  return deepest_of(posed, kinematics,
                    allowed_as_at(home_kinematics(posed), posed, limb_pairs(posed, hand)))
      .depth;
}

TEST(ClearGoals, AreBeforeTheBody) {
  const PosedBody posed = with_big_head();
  Random random(97);
  int drawn_back = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const ReachProblem problem = reach_with(posed, "right_hand", random_point(random));
    const ClosestReach reach = closest_reach(problem);
    if (reach.reached() || depth_at(posed, reach.angles) < 0.02) continue;
    const ReachProblem clear = clear_goals(problem, reach);
    const EffectorPath& path = problem.goals[0].path;
    if (clear.goals[0].path.goal == path.goal) continue;
    ++drawn_back;
    ASSERT_LE(depth_at(posed, closest_reach(clear).angles), kDetourDepth);
    const Vec3d way = path.goal - path.start;
    const double share = dot(clear.goals[0].path.goal - path.start, way) / dot(way, way);
    ASSERT_NEAR(norm(path.start + way * share - clear.goals[0].path.goal), 0.0, 1e-12);
    ASSERT_GT(share, 0.05);
    ASSERT_LT(share, 0.95);
  }
  EXPECT_GE(drawn_back, 5);
}

TEST(ClearGoals, AreTheSameWhereThePostureIsClear) {
  for (const Vec3d& goal : {Vec3d{-0.2, 1.2, 0.4}, Vec3d{-1.5, 1.0, 1.0}}) {
    const ReachProblem problem = reach_with(full(), "right_hand", goal);
    const ReachProblem clear = clear_goals(problem, closest_reach(problem));
    EXPECT_EQ(clear.goals[0].path.goal, goal);
  }
}

}  // namespace
}  // namespace shigusa
