// SPDX-License-Identifier: MIT
#include <shigusa/kinematics/penetration.hpp>

namespace shigusa {
namespace {

// Where on the segment a0-a1 (0..1) the point p is nearest.
double nearest_share(const Vec3d& a0, const Vec3d& a1, const Vec3d& p) {
  const Vec3d a = a1 - a0;
  const double square = dot(a, a);
  return square > 0.0 ? clamp(dot(p - a0, a) / square, 0.0, 1.0) : 0.0;
}

}  // namespace

SegmentPair nearest_points(const Vec3d& a0, const Vec3d& a1, const Vec3d& b0, const Vec3d& b1) {
  const Vec3d a = a1 - a0;
  const Vec3d b = b1 - b0;
  const Vec3d between = a0 - b0;
  const double aa = dot(a, a);
  const double bb = dot(b, b);
  const double ab = dot(a, b);
  const double determinant = aa * bb - ab * ab;
  // the nearest points of the two lines, then held to the segments one after the other
  double s = determinant > 1e-12 * aa * bb
                 ? clamp((ab * dot(b, between) - bb * dot(a, between)) / determinant, 0.0, 1.0)
                 : 0.0;
  const double t = nearest_share(b0, b1, a0 + a * s);
  s = nearest_share(a0, a1, b0 + b * t);
  return {a0 + a * s, b0 + b * t};
}

Penetration limb_penetration(const BodyModel& body, const Kinematics<double>& kinematics,
                             const Effector& effector) {
  Penetration deepest;
  const std::string& first = body.dof(effector.limb_root).joint;
  for (const Capsule& limb : body.capsules()) {
    if (!body.moves(effector.limb_root, limb.link) || body.dof(limb.link).joint == first) continue;
    for (const Capsule& part : body.capsules()) {
      if (body.moves(effector.limb_root, part.link)) continue;
      const SegmentPair pair = nearest_points(
          kinematics.point(limb.link, limb.from), kinematics.point(limb.link, limb.to),
          kinematics.point(part.link, part.from), kinematics.point(part.link, part.to));
      const Vec3d apart = pair.on_a - pair.on_b;
      const double depth = limb.radius + part.radius - norm(apart);
      if (depth > deepest.depth) deepest = {depth, normalized(apart, {0, 0, 1})};
    }
  }
  return deepest;
}

}  // namespace shigusa
