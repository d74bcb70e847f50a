// SPDX-License-Identifier: MIT
#include <algorithm>

#include "body/anthropometry.hpp"
#include "core/index.hpp"
#include "robot_builder.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

// Corners this near (m) to the lowest one touch the floor as well.
constexpr double kSoleSlack = 0.01;
// Shapes that leave a sole smaller than this (share of the stature) are no foot's.
constexpr double kLeastSole = 0.02;

struct Bounds {
  double left = 0.0;
  double right = 0.0;
  double front = 0.0;
  double back = 0.0;
};

// Around the corners up to that height.
Bounds bounds_below(const std::vector<Vec3d>& corners, double height) {
  constexpr double kNone = 1e9;
  Bounds b{-kNone, kNone, -kNone, kNone};
  for (const Vec3d& c : corners) {
    if (c.y > height) continue;
    b = {max(b.left, c.x), min(b.right, c.x), max(b.front, c.z), min(b.back, c.z)};
  }
  return b;
}

RobotSole rectangle(const Bounds& b, double y, bool guessed) {
  return {{Vec3d{b.left, y, b.front}, Vec3d{b.left, y, b.back}, Vec3d{b.right, y, b.back},
           Vec3d{b.right, y, b.front}},
          guessed};
}

}  // namespace

RobotSole robot_sole(const Robot& robot, const PlacedRobot& placed, const std::vector<int>& links,
                     const Vec3d& ankle, double stature) {
  std::vector<Vec3d> corners;
  double lowest_frame = ankle.y;
  for (const int link : links) {
    const auto i = index(link);
    for (const Vec3d& corner : robot.links[i].corners) corners.push_back(placed.links[i] * corner);
    lowest_frame = min(lowest_frame, placed.links[i].translation.y);
  }
  const double length = F::kFootLength * stature;
  const double half = 0.5 * F::kFootBreadth * stature;
  const Bounds person{ankle.x + half, ankle.x - half, ankle.z + (1.0 - kHeelShare) * length,
                      ankle.z - kHeelShare * length};
  if (!corners.empty()) {
    double y = corners[0].y;
    for (const Vec3d& c : corners) y = min(y, c.y);
    const double least = kLeastSole * stature;
    const auto is_sole = [&](const Bounds& b) {
      return b.left - b.right > least && b.front - b.back > least;
    };
    // the sole is where the shapes end: all of the foot's tell its outline where the lowest do not
    for (const double slack : {kSoleSlack, ankle.y - y}) {
      const Bounds b = bounds_below(corners, y + slack);
      if (is_sole(b)) return rectangle(b, y, false);
    }
    if (y < ankle.y) return rectangle(person, y, true);
  }
  const double drop = ankle.y - lowest_frame;
  const bool has_frame = drop > 0.01 * stature && drop < 0.15 * stature;
  return rectangle(person, has_frame ? lowest_frame : ankle.y - F::kAnkleHeight * stature, true);
}

}  // namespace shigusa
