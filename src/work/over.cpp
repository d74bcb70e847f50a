// SPDX-License-Identifier: MIT
#include "work/over.hpp"

#include <vector>

#include "kinematics/penetration.hpp"

namespace shigusa {
namespace {

// Points of a hand's straight way that are looked at, and height (m) of the place above what is in
// the way: a hand's length and some.
constexpr int kStraightPoints = 24;
constexpr double kOver = 0.25;

// Highest point (m) of an obstacle.
double top_of(const Obstacle& obstacle) {
  const Mat3d axes = to_matrix(obstacle.rotation);
  const Vec3d half = obstacle.size * 0.5;
  return obstacle.position.y + obstacle.radius + abs(axes.cx.y) * half.x + abs(axes.cy.y) * half.y +
         abs(axes.cz.y) * half.z;
}

}  // namespace

std::optional<Vec3d> place_over(std::span<const Obstacle> obstacles, const Vec3d& from,
                                const Vec3d& to) {
  const std::vector<PlacedBox> boxes = placed_boxes({obstacles.begin(), obstacles.end()});
  Vec3d middle{};
  double top = -1e9;
  double inside = 0.0;
  for (int k = 1; k < kStraightPoints; ++k) {
    const Vec3d at = from + (to - from) * (1.0 * k / kStraightPoints);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      if (box_distance(boxes[b], at) > 0.0) continue;
      middle += at;
      inside += 1.0;
      top = max(top, top_of(obstacles[b]));
    }
  }
  if (inside == 0.0) return std::nullopt;
  middle = middle * (1.0 / inside);
  return Vec3d{middle.x, max(middle.y, top + kOver), middle.z};
}

}  // namespace shigusa
