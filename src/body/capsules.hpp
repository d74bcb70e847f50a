// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>

namespace shigusa {

// Nearest points of two line segments, and their parameters (0..1).
struct SegmentPair {
  Vec3d on_a{};
  Vec3d on_b{};
  double along_a = 0.0;
  double along_b = 0.0;
};

// Nearest points of the segments a0-a1 and b0-b1; any of several equally near ones. Segments may be
// points.
[[nodiscard]] SegmentPair nearest_points(const Vec3d& a0, const Vec3d& a1, const Vec3d& b0,
                                         const Vec3d& b1);

// Penetration depth (m) of two capsules in one frame at the nearest points of their axes; negative:
// their distance.
[[nodiscard]] double capsule_depth(const Capsule& a, const Capsule& b);

// Increase of a capsule's radius (m) from its first to its second end.
[[nodiscard]] inline double taper_of(const Capsule& capsule) {
  return capsule.to_radius - capsule.radius;
}
[[nodiscard]] inline double thickest(const Capsule& capsule) {
  return max(capsule.radius, capsule.to_radius);
}

}  // namespace shigusa
