// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>

namespace shigusa {

// Nearest points of two line segments, and where on them these are (0..1).
struct SegmentPair {
  Vec3d on_a{};
  Vec3d on_b{};
  double along_a = 0.0;
  double along_b = 0.0;
};

// The points of the segments a0-a1 and b0-b1 that are nearest to each other; of equally near ones
// any. Segments may be points.
[[nodiscard]] SegmentPair nearest_points(const Vec3d& a0, const Vec3d& a1, const Vec3d& b0,
                                         const Vec3d& b1);

// How deep (m, less than 0: that far apart) two capsules of one frame are in each other where their
// lines are nearest.
[[nodiscard]] double capsule_depth(const Capsule& a, const Capsule& b);

// By how much (m) a capsule is thicker at its second end.
[[nodiscard]] inline double taper_of(const Capsule& capsule) {
  return capsule.to_radius - capsule.radius;
}
[[nodiscard]] inline double thickest(const Capsule& capsule) {
  return max(capsule.radius, capsule.to_radius);
}

}  // namespace shigusa
