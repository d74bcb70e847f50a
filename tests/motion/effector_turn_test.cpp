// SPDX-License-Identifier: MIT
#include "motion/effector_turn.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/minimum_jerk.hpp"

namespace shigusa {
namespace {

constexpr double kRounding = 1e-12;

double apart(const Mat3d& a, const Mat3d& b) { return norm(rotation_vector(a * transpose(b))); }

TEST(RotationBy, IsWhatTheRotationVectorSays) {
  for (const Vec3d& vector : {Vec3d{0.3, -1.2, 0.5}, Vec3d{0, 0, 3.1}, Vec3d{1e-9, 0, 0}}) {
    EXPECT_LT(norm(rotation_vector(rotation_by(vector)) - vector), kRounding);
  }
  EXPECT_EQ(rotation_by<double>({}), Mat3d{});
}

TEST(EffectorTurn, GoesFromStartToGoalByTheMinimumJerkShareOfTheAngle) {
  EffectorTurn turn;
  turn.kind = Turning::whole;
  turn.start = rotation(Axis::x, 0.7);
  turn.goal = rotation_by<double>({0.4, 1.5, -0.8}) * turn.start;
  const double whole = apart(turn.goal, turn.start);
  EXPECT_LT(apart(turn.at(0.0), turn.start), kRounding);
  EXPECT_EQ(turn.at(1.0), turn.goal);
  for (const double tau : {0.2, 0.5, 0.9}) {
    EXPECT_NEAR(apart(turn.at(tau), turn.start), minimum_jerk(tau) * whole, 1e-9);
    EXPECT_NEAR(apart(turn.at(tau), turn.goal), (1.0 - minimum_jerk(tau)) * whole, 1e-9);
  }
  EXPECT_NEAR(turn.miss(turn.start), whole, kRounding);
  EXPECT_NEAR(turn.miss(turn.goal), 0.0, kRounding);
}

TEST(EffectorTurn, AxisGoesThereInThePlaneOfBoth) {
  EffectorTurn turn;
  turn.kind = Turning::axis;
  turn.start = rotation(Axis::y, 0.3);
  turn.axis = {1, 0, 0};
  turn.direction = {0, 1, 0};
  const Vec3d from = turn.start * turn.axis;
  for (const double tau : {0.0, 0.3, 0.6, 1.0}) {
    const Vec3d now = turn.at(tau).cx;
    EXPECT_NEAR(norm(now), 1.0, kRounding);
    EXPECT_NEAR(dot(now, normalized(cross(from, turn.direction))), 0.0, kRounding);
    EXPECT_NEAR(std::acos(dot(now, from)), minimum_jerk(tau) * kPi / 2, 1e-7);
  }
  // it may turn about the axis
  EXPECT_NEAR(turn.miss(rotation(Axis::z, kPi / 2) * rotation(Axis::x, 1.0)), 0.0, kRounding);
}

TEST(TurnBetween, TakesOneDirectionToTheOther) {
  const Vec3d a = normalized({0.2, -0.5, 0.9});
  for (const Vec3d& b : {normalized({1, 1, 0}), normalized({-0.21, 0.5, -0.9}), -a, a}) {
    EXPECT_LT(norm(rotation_by(turn_between(a, b)) * a - b), 1e-9);
    EXPECT_LE(norm(turn_between(a, b)), kPi + kRounding);
  }
}

}  // namespace
}  // namespace shigusa
