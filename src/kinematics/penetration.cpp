// SPDX-License-Identifier: MIT
#include "kinematics/penetration.hpp"

#include <algorithm>

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

std::vector<CapsulePair> limb_pairs(const BodyModel& body, const Effector& effector) {
  std::vector<CapsulePair> pairs;
  const std::string& first = body.dof(effector.limb_root).joint;
  const auto count = static_cast<int>(body.capsules().size());
  const auto link = [&](int c) { return body.capsules()[static_cast<std::size_t>(c)].link; };
  for (int limb = 0; limb < count; ++limb) {
    if (!body.moves(effector.limb_root, link(limb)) || body.dof(link(limb)).joint == first) {
      continue;
    }
    for (int part = 0; part < count; ++part) {
      if (!body.moves(effector.limb_root, link(part))) pairs.push_back({limb, part});
    }
  }
  return pairs;
}

std::vector<CapsulePair> leg_pairs(const BodyModel& body) {
  std::vector<CapsulePair> pairs;
  const auto count = static_cast<int>(body.capsules().size());
  const auto leg = [&](int c) { return body.capsules()[static_cast<std::size_t>(c)].leg; };
  for (int left = 0; left < count; ++left) {
    for (int right = 0; right < count; ++right) {
      if (leg(left) == Side::left && leg(right) == Side::right) pairs.push_back({left, right});
    }
  }
  return pairs;
}

std::vector<CapsulePair> all_limb_pairs(const BodyModel& body) {
  std::vector<CapsulePair> all = leg_pairs(body);
  for (const Effector& effector : body.effectors()) {
    for (const CapsulePair& pair : limb_pairs(body, effector)) {
      const auto same = [&](const CapsulePair& known) {
        return (known.limb == pair.part && known.part == pair.limb) ||
               (known.limb == pair.limb && known.part == pair.part);
      };
      if (std::none_of(all.begin(), all.end(), same)) all.push_back(pair);
    }
  }
  return all;
}

Penetration limb_penetration(const BodyModel& body, const Kinematics<double>& kinematics,
                             const Effector& effector) {
  Penetration deepest;
  for (const CapsulePair& pair : limb_pairs(body, effector)) {
    const Capsule& limb = body.capsules()[static_cast<std::size_t>(pair.limb)];
    const Capsule& part = body.capsules()[static_cast<std::size_t>(pair.part)];
    const PlacedCapsule<double> a = placed_capsule(limb, kinematics);
    const PlacedCapsule<double> b = placed_capsule(part, kinematics);
    const SegmentPair nearest = nearest_points(a.from, a.to, b.from, b.to);
    const Vec3d apart = nearest.on_a - nearest.on_b;
    const double depth = limb.radius + part.radius - norm(apart);
    if (depth > deepest.depth) deepest = {depth, normalized(apart, {0, 0, 1})};
  }
  return deepest;
}

}  // namespace shigusa
