// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/kinematics/forward_kinematics.hpp>

namespace shigusa {

// Nearest points of two line segments.
struct SegmentPair {
  Vec3d on_a{};
  Vec3d on_b{};
};

// The points of the segments a0-a1 and b0-b1 that are nearest to each other; of equally near ones
// any. Segments may be points.
[[nodiscard]] SegmentPair nearest_points(const Vec3d& a0, const Vec3d& a1, const Vec3d& b0,
                                         const Vec3d& b1);

// How deep a limb's last part is inside the rest of the body.
struct Penetration {
  double depth = -1e9;  // m; negative: that far apart
  Vec3d outward{};      // unit vector, world: the shortest way out for the limb
};

// The deepest penetration of an effector's limb, but for its first segment, which its joint holds
// to the trunk, into the capsules of links that the limb does not move.
[[nodiscard]] Penetration limb_penetration(const BodyModel& body,
                                           const Kinematics<double>& kinematics,
                                           const Effector& effector);

}  // namespace shigusa
