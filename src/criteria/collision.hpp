// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <vector>

#include "core/check.hpp"
#include "core/index.hpp"
#include "criteria/mean_and_worst.hpp"
#include "criteria/motion_frame.hpp"
#include "kinematics/penetration.hpp"

namespace shigusa {

// All pairs that can collide in a body with what it holds, with their depths in the start posture,
// which are not penalised.
struct CollisionPairs {
  // defined in the source file, shared by all SIMD sets
  CollisionPairs();
  CollisionPairs(const CollisionPairs&);
  CollisionPairs(CollisionPairs&&) noexcept;
  CollisionPairs& operator=(const CollisionPairs&);
  CollisionPairs& operator=(CollisionPairs&&) noexcept;
  ~CollisionPairs();

  struct Pair {
    int limb = 0;          // capsule
    int other = 0;         // capsule or obstacle
    double allowed = 0.0;  // m, positive depth in the start posture
    double give = 0.0;     // m, compliance of the softer of both
    float near = 0.0F;    // m², of parts and held things: squared distance of midpoints from which
                          // they are apart
    float part = 1.0F;    // of the floor: share of the capsule that counts, from its first end
    double length = 0.0;  // m, of the limb's axis
  };
  // A thing in a hand, as a box in the frame of a link.
  struct Held {
    int link = 0;
    PlacedBox box{};
  };
  std::vector<Pair> parts;      // limbs and parts of the body
  std::vector<Pair> held;       // a capsule of the body and one of `things`
  std::vector<Pair> obstacles;  // any capsule and one of `shapes`
  std::vector<Pair> floor;      // capsules of arms with a wrist; `other` is unused
  std::vector<PlacedBox> shapes;
  std::vector<Held> things;
};
[[nodiscard]] CollisionPairs collision_pairs(const BodyModel& body, const CriteriaContext& context);

enum class CollisionKind { part, held, obstacle, floor };

// Calls visit(pair, kind, depth in m beyond the allowed one) for all pairs that can collide, except
// parts that are apart in all lanes. `placed` is scratch memory, one element for each of the body's
// capsules.
template <class S, class Pairs, class Visitor>
void visit_collisions(const BodyModel& body, Pairs& pairs, const Kinematics<S>& kinematics,
                      std::span<PlacedCapsule<S>> placed, Visitor&& visit) {
  const auto& capsules = body.capsules();
  for (std::size_t c = 0; c < placed.size(); ++c) {
    const Capsule& capsule = capsules[c];
    place_capsule(capsule.link, to_scalar<Element<S>>(capsule.from),
                  to_scalar<Element<S>>(capsule.to), kinematics, placed[c]);
  }
  for (auto& pair : pairs.parts) {
    const PlacedCapsule<S>& limb = placed[index(pair.limb)];
    const PlacedCapsule<S>& part = placed[index(pair.other)];
    const Vec3<S> between = limb.middle - part.middle;
    const S square = dot(between, between);
    if (!any(square < S(pair.near))) continue;
    const Capsule& of_limb = capsules[index(pair.limb)];
    const Capsule& of_part = capsules[index(pair.other)];
    if (!any(may_touch(limb, part, between, square, thickest(of_limb) + thickest(of_part))))
      continue;
    visit(pair, CollisionKind::part,
          depth_of(limb, part, of_limb.radius + of_part.radius - pair.allowed, taper_of(of_limb),
                   taper_of(of_part)));
  }
  for (auto& pair : pairs.held) {
    const CollisionPairs::Held& thing = pairs.things[index(pair.other)];
    const Mat3<S>& turn = kinematics.link_rotation(thing.link);
    const Vec3<S>& origin = kinematics.link_origin(thing.link);
    const PlacedCapsule<S>& limb = placed[index(pair.limb)];
    const auto local = [&](const Vec3<S>& p) { return transpose_times(turn, p - origin); };
    const Vec3<S> between = local(limb.middle) - to_scalar<S>(thing.box.position);
    if (!any(dot(between, between) < S(pair.near))) continue;
    const Capsule& of_limb = capsules[index(pair.limb)];
    const double touches = of_limb.radius - pair.allowed;
    const S apart = axis_distance(thing.box, PlacedCapsule<S>{local(limb.from), local(limb.to), {}},
                                  pair.length, taper_of(of_limb), touches);
    visit(pair, CollisionKind::held, S(touches) - apart);
  }
  for (auto& pair : pairs.obstacles) {
    const PlacedBox& obstacle = pairs.shapes[index(pair.other)];
    const Capsule& of_limb = capsules[index(pair.limb)];
    const double touches = of_limb.radius - pair.allowed;
    const S apart =
        axis_distance(obstacle, placed[index(pair.limb)], pair.length, taper_of(of_limb), touches);
    visit(pair, CollisionKind::obstacle, S(touches) - apart);
  }
  for (auto& pair : pairs.floor) {
    const PlacedCapsule<S>& limb = placed[index(pair.limb)];
    const S part(static_cast<Element<S>>(pair.part));
    const S end = limb.from.y + part * (limb.to.y - limb.from.y);
    const S height = min(limb.from.y, end - part * S(taper_of(capsules[index(pair.limb)])));
    visit(pair, CollisionKind::floor, S(capsules[index(pair.limb)].radius - pair.allowed) - height);
  }
}

// Penalty of arms that pass through the body, parts that pass through obstacles, and arms with a
// wrist that pass through the floor at y = 0, in [0, 1]. With d the depth of the deepest pair of
// capsules, beyond the depth in the start posture and the compliance of the flesh, as a share of
// `full`, clamped to [0, 1]:  P = ½ mean_t d + ½ max_t d.
template <class S>
class Collision {
 public:
  static constexpr CriterionKind kKind = CriterionKind::collision;

  Collision(const BodyModel& body, const CriteriaContext& context, double full)
      : body_(&body),
        pairs_(collision_pairs(body, context)),
        per_full_(1.0 / full),
        placed_(body.capsules().size()) {}

  void reset() { seen_.reset(); }

  void add(const PlacedFrame<S>& frame) {
    const S share = clamp(deepest(frame.kinematics) * S(per_full_), S(0), S(1));
    seen_.add(share);
  }

  [[nodiscard]] S penalty() const { return seen_.penalty(); }

 private:
  [[nodiscard]] S deepest(const Kinematics<S>& kinematics) {
    S most(0);
    const auto keep = [&most](const auto& pair, CollisionKind, const S& depth) {
      most = max(most, depth - S(pair.give));
    };
    visit_collisions<S>(*body_, pairs_, kinematics, placed_, keep);
    return most;
  }

  const BodyModel* body_;
  CollisionPairs pairs_;
  double per_full_;
  std::vector<PlacedCapsule<S>> placed_;
  MeanAndWorst<S> seen_;
};

}  // namespace shigusa
