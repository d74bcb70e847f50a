// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <vector>

namespace shigusa {

// Sole relative to a point of a foot's link, which limits goals for the foot.
struct Sole {
  std::vector<Vec3d> corners;  // m, relative to the point, in the link's axes; for a lifting heel
                               // those of the forefoot
  double floor = 0.0;          // m, world: 0, or lower if the sole starts lower

  // Least height (m, world) of the point at which no corner is below the floor, for a link
  // orientation R_WL.
  [[nodiscard]] double least_height(const Mat3d& turn) const;
  // The same for a link that may turn about one of its axes, of which only the direction is given:
  // the least over all rotations. Both are unit vectors, `axis` in the link's frame.
  [[nodiscard]] double least_height(const Vec3d& axis, const Vec3d& direction) const;
};

// Sole relative to a point of the foot's link (m, in the link's frame); `start`: X_WL in the start
// posture.
[[nodiscard]] Sole sole_under(const Foot& foot, const Vec3d& point, const Transformd& start);

}  // namespace shigusa
