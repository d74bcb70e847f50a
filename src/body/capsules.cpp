// SPDX-License-Identifier: MIT
#include "body/capsules.hpp"

namespace shigusa {
namespace {

// Parameter (0..1) of the point on the segment a0-a1 nearest to p.
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
  // nearest points of the two lines, clamped to the segments one after the other
  double s = determinant > 1e-12 * aa * bb
                 ? clamp((ab * dot(b, between) - bb * dot(a, between)) / determinant, 0.0, 1.0)
                 : 0.0;
  const double t = nearest_share(b0, b1, a0 + a * s);
  s = nearest_share(a0, a1, b0 + b * t);
  return {a0 + a * s, b0 + b * t, s, t};
}

double capsule_depth(const Capsule& a, const Capsule& b) {
  const SegmentPair pair = nearest_points(a.from, a.to, b.from, b.to);
  return a.radius + b.radius + pair.along_a * taper_of(a) + pair.along_b * taper_of(b) -
         norm(pair.on_a - pair.on_b);
}

}  // namespace shigusa
