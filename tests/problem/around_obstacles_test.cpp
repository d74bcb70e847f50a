// SPDX-License-Identifier: MIT
#include "problem/around_obstacles.hpp"

#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

#include "kinematics/penetration.hpp"

namespace shigusa {
namespace {

const Obstacle kTable{.name = "table", .position = {0, 0.75, 0.6}, .size = {1.4, 0.04, 0.7}};
const Obstacle kPost{.name = "post", .position = {-0.2, 1.0, 0.3}, .size = {0.06, 2.0, 0.06}};

Effector right_hand() { return human_body().body.effectors()[0]; }

EffectorPath led(const Vec3d& from, const Vec3d& to, const std::vector<Obstacle>& obstacles) {
  EffectorPath path{.start = from, .goal = to};
  go_around_obstacles({.obstacles = obstacles}, right_hand(), path);
  return path;
}

double least_distance(const EffectorPath& path, const Obstacle& obstacle) {
  const PlacedBox box = placed_boxes({&obstacle, 1}).front();
  double least = 1.0;
  for (int k = 0; k <= 100; ++k) least = min(least, box_distance(box, path.at(k / 100.0)));
  return least;
}

TEST(GoAroundObstacles, StaysStraightWhereNothingIsNear) {
  EXPECT_EQ(led({-0.2, 0.8, 0.1}, {-0.2, 1.4, 0.5}, {}).detour, Vec3d{});
  EXPECT_EQ(led({-0.2, 1.2, 0.1}, {-0.2, 1.6, 0.5}, {kTable}).detour, Vec3d{});
}

TEST(GoAroundObstacles, GoesUpBeforeATableAndThenAhead) {
  for (const double ahead : {0.35, 0.5, 0.7}) {
    const EffectorPath path = led({-0.22, 0.72, 0.08}, {-0.2, 0.92, ahead}, {kTable});
    EXPECT_GT(path.detour.y, 0.0) << ahead;
    const EffectorPath straight{.start = path.start, .goal = path.goal};
    EXPECT_GT(least_distance(path, kTable), 0.09) << ahead;
    EXPECT_LT(least_distance(straight, kTable), 0.07) << ahead;
    EXPECT_EQ(path.at(1.0), path.goal);
  }
}

TEST(GoAroundObstacles, GoesAsideAroundAPost) {
  const EffectorPath path = led({-0.2, 0.9, 0.05}, {-0.2, 1.1, 0.6}, {kPost});
  EXPECT_GT(least_distance(path, kPost), 0.1);
}

TEST(GoAroundObstacles, AnObstacleAtTheGoalIsNoneOnTheWay) {
  const Obstacle box{.name = "box", .position = {-0.2, 1.2, 0.65}, .size = {0.2, 0.2, 0.2}};
  EXPECT_EQ(led({-0.2, 0.8, 0.1}, {-0.2, 1.2, 0.54}, {box}).detour, Vec3d{});
}

TEST(GoAroundObstacles, HandsReachOverTheEdgeOfATable) {
  for (const double side : {1.0, -1.0}) {
    Task task(human_body());
    task.goals = {{side > 0.0 ? "left_hand" : "right_hand", {side * 0.2, 0.9, 0.4}}};
    task.obstacles = {kTable};
    const Candidate best = generate(task).value().candidates.front();
    EXPECT_EQ(best.judgement.verdict, Verdict::possible);
    EXPECT_EQ(best.goals[0].path, PathKind::detour);
  }
}

}  // namespace
}  // namespace shigusa
