// SPDX-License-Identifier: MIT
#include "kinematics/penetration.hpp"

#include <algorithm>

namespace shigusa {
std::vector<CapsulePair> limb_pairs(const BodyModel& body, const Effector& effector) {
  std::vector<CapsulePair> pairs;
  const auto count = static_cast<int>(body.capsules().size());
  const auto moves = [&](int c) {
    return body.moves(effector.limb_root, body.capsules()[static_cast<std::size_t>(c)].link);
  };
  for (int limb = 0; limb < count; ++limb) {
    if (!moves(limb) || body.capsules()[static_cast<std::size_t>(limb)].grown_on) continue;
    for (int part = 0; part < count; ++part) {
      if (!moves(part)) pairs.push_back({limb, part});
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

std::vector<CapsulePair> allowed_as_at(const Kinematics<double>& start, const BodyModel& body,
                                       std::vector<CapsulePair> pairs) {
  for (CapsulePair& pair : pairs) {
    pair.allowed = max(deepest_of(body, start, {&pair, 1}).depth, 0.0);
  }
  return pairs;
}

double give_of(const BodyModel& body, const CapsulePair& pair) {
  const auto give = [&](int c) { return body.capsules()[static_cast<std::size_t>(c)].give; };
  return max(give(pair.limb), give(pair.part));
}

Penetration limb_penetration(const BodyModel& body, const Kinematics<double>& kinematics,
                             const Effector& effector) {
  return deepest_of(body, kinematics, limb_pairs(body, effector));
}

std::vector<PlacedBox> placed_boxes(std::span<const Obstacle> obstacles) {
  std::vector<PlacedBox> boxes;
  for (const Obstacle& obstacle : obstacles) {
    boxes.push_back(
        {obstacle.position, obstacle.size * 0.5, obstacle.radius, to_matrix(obstacle.rotation)});
  }
  return boxes;
}

Penetration deepest_of(const BodyModel& body, const Kinematics<double>& kinematics,
                       std::span<const CapsulePair> pairs) {
  Penetration deepest;
  for (const CapsulePair& pair : pairs) {
    const Capsule& limb = body.capsules()[static_cast<std::size_t>(pair.limb)];
    const Capsule& part = body.capsules()[static_cast<std::size_t>(pair.part)];
    const PlacedCapsule<double> a = placed_capsule(limb, kinematics);
    const PlacedCapsule<double> b = placed_capsule(part, kinematics);
    const SegmentPair nearest = nearest_points(a.from, a.to, b.from, b.to);
    const Vec3d apart = nearest.on_a - nearest.on_b;
    const double depth = limb.radius + part.radius + nearest.along_a * taper_of(limb) +
                         nearest.along_b * taper_of(part) - norm(apart) - pair.allowed;
    if (depth > deepest.depth) deepest = {depth, normalized(apart, {0, 0, 1})};
  }
  return deepest;
}

}  // namespace shigusa
