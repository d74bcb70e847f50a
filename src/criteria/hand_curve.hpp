// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"
#include "criteria/posture_points.hpp"
#include "kinematics/penetration.hpp"

namespace shigusa {

// Offset of people's hand paths from the straight way, forwards, as shares of its length: on a
// level way the first; the second is added on a way straight down, and subtracted on one straight
// up. Recorded: 0.05 to 0.17 down to the floor, -0.03 to -0.07 up to shelves.
inline constexpr double kBowLevel = 0.03;
inline constexpr double kBowDown = 0.08;
// Mean over a motion's time of the offset of a bow of 1 (see path_bow): ∫ 4 s (1 - s) along the
// minimum-jerk profile.
inline constexpr double kMeanBow = 0.4329;
// Distance (m) of an obstacle from the straight way within which the hand has to go around it, and
// the points of the way at which it is taken.
inline constexpr double kWayClear = 0.12;
inline constexpr int kWayPoints = 8;

// Penalty of hand paths that do not deviate from the straight way as people's do, by some tenth of
// it and in a typical direction, in [0, 1]. For each goal's hand, o is the mean offset of its
// positions from the midpoint of its straight way, perpendicular to that and over the bow's mean
// share of time, n the same offset of people, m = mean |o - n|² / offset² and P = m / (1 + m): far
// from people's way, too, nearer is better. It fades where an obstacle is near the straight way. A
// hand that moves by less than 5 cm, and a body without hands, has no penalty.
template <class S>
class HandCurve {
 public:
  static constexpr CriterionKind kKind = CriterionKind::hand_curve;

  HandCurve(const BodyModel& body, const CriteriaContext& context, double offset)
      : hands_(goal_hands(body, context)),
        sums_(hands_.size()),
        starts_(sums_),
        ends_(sums_),
        boxes_(placed_boxes(context.obstacles)),
        per_square_(1.0 / (offset * offset)) {}

  void reset() { frames_ = 0; }

  void add(const PlacedFrame<S>& frame) {
    for (std::size_t h = 0; h < hands_.size(); ++h) {
      ends_[h] = hands_[h].hand.in(frame.kinematics);
      if (frames_ == 0) {
        starts_[h] = ends_[h];
        sums_[h] = ends_[h] * S(0.5);
      } else {
        sums_[h] += ends_[h];
      }
    }
    frames_ += 1;
  }

  [[nodiscard]] S penalty() const {
    if (frames_ == 0 || hands_.empty()) return S(0);
    S sum(0);
    for (std::size_t h = 0; h < hands_.size(); ++h) sum = sum + square_off(h);
    const S off = sum * S(per_square_ / static_cast<double>(hands_.size()));
    return off / (S(1) + off);
  }

 private:
  [[nodiscard]] S square_off(std::size_t h) const {
    const Vec3<S> way = ends_[h] - starts_[h];
    const S length = max(norm(way), S(1e-6));
    const Vec3<S> along = way * (S(1) / length);
    // both ends count half
    Vec3<S> off = (sums_[h] - ends_[h] * S(0.5)) * S(1.0 / max(frames_ - 1, 1)) -
                  (starts_[h] + ends_[h]) * S(0.5);
    off = (off - along * dot(off, along)) * (S(1.0 / kMeanBow) / length);
    // forwards, perpendicular to the way; a way straight forwards has no bow
    const Vec3<S> forward = Vec3<S>{S(0), S(0), S(1)} - along * along.z;
    off = off - forward * (S(kBowLevel) - S(kBowDown) * along.y);
    return select(length > S(0.05), dot(off, off) * free_way(h), S(0));
  }

  // 1 for a straight way that is clear of obstacles, 0 for one that is blocked.
  [[nodiscard]] S free_way(std::size_t h) const {
    S least(kWayClear);
    for (const PlacedBox& box : boxes_) {
      for (int k = 0; k < kWayPoints; ++k) {
        const S share(static_cast<double>(k) / kWayPoints);
        least = min(least, box_distance(box, starts_[h] + (ends_[h] - starts_[h]) * share));
      }
    }
    return max(least, S(0)) * S(1.0 / kWayClear);
  }

  std::vector<GoalHand> hands_;
  std::vector<Vec3<S>> sums_;    // m, of positions
  std::vector<Vec3<S>> starts_;  // m
  std::vector<Vec3<S>> ends_;    // m
  std::vector<PlacedBox> boxes_;
  double per_square_;
  int frames_ = 0;
};

}  // namespace shigusa
