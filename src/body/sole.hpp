// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <vector>

namespace shigusa {

// The sole under a point of a foot's link: it says where goals for the foot may be.
struct Sole {
  std::vector<Vec3d> corners;  // m, from the point, in the link's axes; of a heel that lifts, the
                               // forefoot's
  double floor = 0.0;          // m, world: 0, or where the sole starts below that

  // The least height (m, world) of the point with no corner below the floor, of a link turned so
  // (R_WL).
  [[nodiscard]] double least_height(const Mat3d& turn) const;
  // The same for a link that may turn about one of its axes, which points there: the least of all
  // such turns. Both are unit vectors, `axis` in the link's frame.
  [[nodiscard]] double least_height(const Vec3d& axis, const Vec3d& direction) const;
};

// The sole under a point of the foot's link (m, in the link's frame); `start`: where that link is
// in the start posture, X_WL.
[[nodiscard]] Sole sole_under(const Foot& foot, const Vec3d& point, const Transformd& start);

}  // namespace shigusa
