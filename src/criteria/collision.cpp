// SPDX-License-Identifier: MIT
#include "criteria/collision.hpp"

#include <algorithm>

#include "criteria/with_start.hpp"

namespace shigusa {

namespace {

// End of a closed hand beyond its grip, as a share of the open hand: 3 cm of a man's, chosen.
constexpr double kKnuckles = 0.15;

// Radius (m) of a capsule about its midpoint.
double reach_of(const BodyModel& body, int number) {
  const Capsule& capsule = body.capsules()[index(number)];
  return thickest(capsule) + 0.5 * norm(capsule.to - capsule.from);
}

// Whether a capsule belongs to a hand that rests on the named part or obstacle.
bool rests_on(const BodyModel& body, int capsule, const std::string& name,
              const CriteriaContext& context) {
  const int link = body.capsules()[index(capsule)].link;
  return std::any_of(
      context.resting.begin(), context.resting.end(),
      [&](const RestingPlace& place) { return place.link == link && place.on == name; });
}

// Share of a hand's capsule up to its knuckles: on the floor fingers curl about what they take.
float fist_part(const Capsule& hand, const Vec3d& grip) {
  const Vec3d line = hand.to - hand.from;
  const double at = dot(grip - hand.from, line) / max(dot(line, line), 1e-12);
  return static_cast<float>(clamp(at + kKnuckles, 0.0, 1.0));
}

// Adds the floor pairs of a limb. A hand without a wrist points along its forearm, and cannot be
// kept off the floor.
void add_floor(const BodyModel& body, const Effector& effector, CollisionPairs& pairs) {
  if (body.dof(effector.link).part.joint_kind != JointKind::wrist) return;
  const int count = static_cast<int>(body.capsules().size());
  for (int c = 0; c < count; ++c) {
    const int link = body.capsules()[index(c)].link;
    if (!body.moves(effector.limb_root, link)) continue;
    CollisionPairs::Pair& pair = pairs.floor.emplace_back();
    pair.limb = c;
    if (link == effector.link) pair.part = fist_part(body.capsules()[index(c)], effector.point);
  }
}

// Adds the pairs of a thing in a hand and of all that is not of that hand.
void add_held(const BodyModel& body, const HeldShape& thing, CollisionPairs& pairs) {
  const Vec3d half = thing.size * 0.5;
  const int number = static_cast<int>(pairs.things.size());
  pairs.things.push_back({thing.link, {thing.middle, half, thing.radius, to_matrix(thing.turn)}});
  for (int c = 0; c < static_cast<int>(body.capsules().size()); ++c) {
    const Capsule& capsule = body.capsules()[index(c)];
    if (capsule.of_thing || capsule.link == thing.link) continue;
    const double together = reach_of(body, c) + norm(half) + thing.radius;
    CollisionPairs::Pair& pair = pairs.held.emplace_back();
    pair = {.limb = c, .other = number, .give = capsule.give};
    pair.near = static_cast<float>(kApartSlack * together * together);
    pair.length = norm(capsule.to - capsule.from);
  }
}

}  // namespace

CollisionPairs::CollisionPairs() = default;
CollisionPairs::CollisionPairs(const CollisionPairs&) = default;
CollisionPairs::CollisionPairs(CollisionPairs&&) noexcept = default;
CollisionPairs& CollisionPairs::operator=(const CollisionPairs&) = default;
CollisionPairs& CollisionPairs::operator=(CollisionPairs&&) noexcept = default;
CollisionPairs::~CollisionPairs() = default;

CollisionPairs collision_pairs(const BodyModel& body, const CriteriaContext& context) {
  CollisionPairs pairs;
  const auto& capsules = body.capsules();
  for (const CapsulePair& pair : all_limb_pairs(body)) {
    const Capsule& limb = capsules[index(pair.limb)];
    const Capsule& part = capsules[index(pair.part)];
    if (rests_on(body, pair.limb, part.name, context) || limb.of_thing != part.of_thing) continue;
    const double together = reach_of(body, pair.limb) + reach_of(body, pair.part);
    const auto near = static_cast<float>(kApartSlack * together * together);
    pairs.parts.push_back({pair.limb, pair.part, 0.0, give_of(body, pair), near});
  }
  for (const HeldShape& thing : body.definition().held) add_held(body, thing, pairs);
  for (const Effector& effector : body.effectors()) add_floor(body, effector, pairs);
  for (int c = 0; c < static_cast<int>(body.capsules().size()); ++c) {
    for (int o = 0; o < static_cast<int>(context.obstacles.size()); ++o) {
      if (rests_on(body, c, context.obstacles[index(o)].name, context)) continue;
      CollisionPairs::Pair& pair = pairs.obstacles.emplace_back();
      pair = {.limb = c, .other = o};
      pair.length = norm(capsules[index(c)].to - capsules[index(c)].from);
    }
  }
  pairs.shapes = placed_boxes(context.obstacles);
  const Kinematics<double> start = placed(body, context.start);
  std::vector<PlacedCapsule<double>> at_start(body.capsules().size());
  visit_collisions<double>(body, pairs, start, at_start,
                           [](CollisionPairs::Pair& pair, CollisionKind, double depth) {
                             pair.allowed = max(depth, 0.0);
                           });
  return pairs;
}

CollisionFound deepest_collision(const BodyModel& body, const Clip& clip,
                                 const CriteriaContext& context) {
  const CollisionPairs pairs = collision_pairs(body, with_start(context, clip));
  std::vector<PlacedCapsule<double>> capsules(body.capsules().size());
  Kinematics<double> kinematics(body);
  CollisionFound found;
  double worst = 0.0;  // depth relative to the impossible one
  const auto name = [&](const CollisionPairs::Pair& pair, CollisionKind kind) -> std::string {
    const std::size_t other = index(pair.other);
    if (kind == CollisionKind::floor) return "floor";
    if (kind == CollisionKind::held) return body.definition().held[other].name;
    return kind == CollisionKind::part ? body.capsules()[other].name
                                       : context.obstacles[other].name;
  };
  for (int f = 0; f < clip.frames; ++f) {
    forward_kinematics<double>(body, clip.frame(f), kinematics);
    visit_collisions<double>(body, pairs, kinematics, capsules,
                             [&](const CollisionPairs::Pair& pair, CollisionKind kind, double in) {
                               const double depth = in - pair.give;
                               const bool hard = kind == CollisionKind::obstacle;
                               const double yields = hard ? kHardDepth : kFleshDepth;
                               if (!(depth / yields > worst)) return;
                               worst = depth / yields;
                               found = {depth, body.capsules()[index(pair.limb)].name,
                                        name(pair, kind), f * clip.frame_time, hard};
                             });
  }
  return found;
}

}  // namespace shigusa
