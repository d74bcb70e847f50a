// SPDX-License-Identifier: MIT
#include "kinematics/penetration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>
#include <vector>

namespace shigusa {
namespace {

Vec3d random_point(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

// The least distance over a fine grid of points of both segments.
double distance_by_grid(const Vec3d& a0, const Vec3d& a1, const Vec3d& b0, const Vec3d& b1) {
  constexpr int kSteps = 200;
  double least = 1e9;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Vec3d a = a0 + (a1 - a0) * (static_cast<double>(i) / kSteps);
      const Vec3d b = b0 + (b1 - b0) * (static_cast<double>(j) / kSteps);
      least = std::min(least, norm(a - b));
    }
  }
  return least;
}

TEST(NearestPoints, AreAsNearAsAGridFinds) {
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const Vec3d p[] = {random_point(random), random_point(random), random_point(random),
                       random_point(random)};
    const SegmentPair pair = nearest_points(p[0], p[1], p[2], p[3]);
    const double found = norm(pair.on_a - pair.on_b);
    const double grid = distance_by_grid(p[0], p[1], p[2], p[3]);
    EXPECT_LE(found, grid + 1e-12);
    // grid points are up to half a step, 2√3/400, from the nearest ones, on both segments
    EXPECT_GE(found, grid - 2 * 3.5 / 400);
  }
}

TEST(NearestPoints, OfParallelSegmentsAreApartByTheirGap) {
  const SegmentPair pair = nearest_points({0, 0, 0}, {1, 0, 0}, {0.5, 2, 0}, {3, 2, 0});
  EXPECT_NEAR(norm(pair.on_a - pair.on_b), 2.0, 1e-12);
}

TEST(NearestPoints, OfPointsAreThePoints) {
  const SegmentPair pair = nearest_points({1, 2, 3}, {1, 2, 3}, {4, 6, 3}, {4, 6, 3});
  EXPECT_NEAR(norm(pair.on_a - pair.on_b), 5.0, 1e-12);
}

double depth_with(const PosedBody& posed,
                  const std::vector<std::pair<const char*, double>>& angles) {
  std::vector<double> q(posed.home.angles.begin(), posed.home.angles.end());
  for (const auto& [name, angle] : angles) {
    q[static_cast<std::size_t>(*posed.body.find_dof(name))] = radians(angle);
  }
  Kinematics<double> kinematics(posed);
  forward_kinematics<double>(posed, q, kinematics);
  return limb_penetration(posed, kinematics, posed.body.effectors()[0]).depth;
}

TEST(LimbPenetration, OfAHangingArmIsNone) {
  EXPECT_LT(depth_with(half_body(), {}), 0.0);
  EXPECT_LT(depth_with(full_body(), {}), 0.0);
}

TEST(LimbPenetration, OfAForearmAcrossTheBellyIsDeep) {
  EXPECT_GT(
      depth_with(full_body(), {{"right_shoulder.rotation", -90}, {"right_elbow.flexion", 90}}),
      0.05);
}

TEST(LimbPenetration, PointsOutOfTheThigh) {
  const PosedBody posed = full_body();
  std::vector<double> q(posed.home.angles.begin(), posed.home.angles.end());
  q[static_cast<std::size_t>(*posed.body.find_dof("right_shoulder.abduction"))] = radians(-8);
  Kinematics<double> kinematics(posed);
  forward_kinematics<double>(posed, q, kinematics);
  // the arm swings in from the right, so the way out is to the right
  EXPECT_LT(limb_penetration(posed, kinematics, posed.body.effectors()[0]).outward.x, -0.5);
}

}  // namespace
}  // namespace shigusa
