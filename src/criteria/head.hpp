// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>

#include "core/check.hpp"
#include "criteria/mean_and_worst.hpp"
#include "criteria/motion_frame.hpp"

namespace shigusa {

// Angle (rad) between the trunk's forward direction and the direction from the head to the goal, up
// to which neck and eyes turn to it on any side: 45° of the neck, its range in flexion and in
// extension (AAOS), and 35° of the eyes (MIL-STD-1472).
inline constexpr double kGazeFree = radians(80);
// Angle (rad) at which neck and eyes reach their limit: to the side, where the neck rotates by 60°
// (AAOS).
inline constexpr double kGazeLimit = radians(95);

// The same angles for a body with a neck, where only the eyes turn further.
inline constexpr double kEyesFree = radians(35);
inline constexpr double kEyesLimit = radians(60);

// Head and pelvis of a body.
struct HeadPoints {
  int head_link = kBaseLink;
  Vec3d head{};  // m, link frame
  int pelvis_link = kBaseLink;
  Vec3d pelvis{};         // m, link frame
  double distance = 0.0;  // m, between them in the start posture; 0 if the body lacks one
  bool neck = false;      // whether the head turns on the trunk
};
// Finds head and pelvis by the names of the body's nodes, "head" and "hips".
[[nodiscard]] HeadPoints head_points(const BodyModel& body, const State& start);

// Penalty of a head near or below the pelvis, or unable to look at the goal, in [0, 1]: people who
// reach to the floor keep their head up and their eyes on the goal, where gaze arrives before the
// hand (Prablanc et al., Biological Cybernetics 35 (1979) 113-124).
//   low(t) = 1 - (y_head - y_pelvis) / (height · distance),
//   away(t) = (cos 80° - cos a) / (cos 80° - cos 95°),
// each clamped to [0, 1], with a the angle between the trunk's forward direction and the direction
// from the head to the goal; p(t) = max(low, away);   P = ½ mean_t p + ½ max_t p. For a head
// rigidly attached to the trunk the angles include the neck's range; for a body with a neck, a is
// measured from the head's forward direction, and the two angles are 35° and 60°. A body without
// these points has no penalty.
template <class S>
class Head {
 public:
  static constexpr CriterionKind kKind = CriterionKind::head;

  Head(const BodyModel& body, const CriteriaContext& context, double height)
      : points_(head_points(body, context.start)),
        per_height_(points_.distance > 0.0 ? 1.0 / (height * points_.distance) : 0.0),
        looks_(context.gaze.has_value()),
        target_(to_scalar<S>(context.gaze.value_or(Vec3d{}))),
        free_(points_.neck ? kCosEyesFree : kCosFree),
        per_cosine_(1.0 / (free_ - (points_.neck ? kCosEyesLimit : kCosLimit))) {}

  void reset() { seen_.reset(); }

  void add(const PlacedFrame<S>& frame) {
    if (!(points_.distance > 0.0)) return;
    const Kinematics<S>& placed = frame.kinematics;
    const Vec3<S> head = placed.point(points_.head_link, points_.head);
    const Vec3<S> pelvis = placed.point(points_.pelvis_link, points_.pelvis);
    S share = S(1) - (head.y - pelvis.y) * S(per_height_);
    if (looks_) share = max(share, away(placed, head));
    share = clamp(share, S(0), S(1));
    seen_.add(share);
  }

  [[nodiscard]] S penalty() const { return seen_.penalty(); }

 private:
  // Cosines of kGazeFree, kGazeLimit, kEyesFree and kEyesLimit.
  static constexpr double kCosFree = 0.17364817766693;
  static constexpr double kCosLimit = -0.08715574274766;
  static constexpr double kCosEyesFree = 0.81915204428899;
  static constexpr double kCosEyesLimit = 0.5;

  [[nodiscard]] S away(const Kinematics<S>& placed, const Vec3<S>& head) const {
    const Vec3<S> forward = placed.link_rotation(points_.head_link).cz;
    const Vec3<S> offset = target_ - head;
    // a goal at the head itself has no direction
    const S cosine = dot(forward, offset) / max(sqrt(dot(offset, offset)), S(1e-3));
    return (S(free_) - cosine) * S(per_cosine_);
  }

  HeadPoints points_;
  double per_height_;  // 1/m
  bool looks_;
  Vec3<S> target_;  // m, world
  double free_;     // cosine
  double per_cosine_;
  MeanAndWorst<S> seen_;
};

}  // namespace shigusa
