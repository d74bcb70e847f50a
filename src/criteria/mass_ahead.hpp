// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "body/seat.hpp"
#include "criteria/motion_frame.hpp"
#include "criteria/posture_points.hpp"

namespace shigusa {

// Share of the way over the floor from the ankles to the hands' final position by which the centre
// of mass moves in a level reach: little more than the effect of the arm's own mass.
inline constexpr double kMassLevel = 0.08;
// The same share, of the distance beyond kMassNear (m), in a reach down by kLowReach of the stature
// or more. There recorded people's centre of mass moves by 5 to 14 cm, 23 to 61 % of the foot from
// near goals to far ones (Pozzo, Stapley and Papaxanthis, Exp. Brain Res. 144 (2002) 343).
inline constexpr double kMassLow = 0.34;
inline constexpr double kMassNear = 0.18;
inline constexpr double kLowReach = 0.3;

// Penalty of a centre of mass that does not follow the hands at the end of the motion, in [0, 1]:
// people do not hold it back. With c its displacement over the floor from a standing person's, g
// the way from the middle of the ankles to the middle of the goals' hands, n people's share of g,
// and q = |c - n|² / distance², P = q / (1 + q). Aside it counts in low reaches alone, as the body
// stays in level ones; who sits leans by the trunk's own criterion, and has no penalty.
template <class S>
class MassAhead {
 public:
  static constexpr CriterionKind kKind = CriterionKind::mass_ahead;

  MassAhead(const BodyModel& body, const CriteriaContext& context, double distance)
      : points_(posture_points(body, context.start)),
        hands_(goal_hands(body, context)),
        per_drop_(body.stature() > 0.0 ? 1.0 / (kLowReach * body.stature()) : 0.0),
        per_square_(1.0 / (distance * distance)) {
    if (sits(body)) hands_.clear();
  }

  void reset() { off_ = S(0); }

  void add(const PlacedFrame<S>& frame) {
    if (!points_.found || hands_.empty()) return;
    Vec3<S> hand{};
    for (const GoalHand& goal : hands_) hand += goal.hand.in(frame.kinematics);
    hand = hand * S(1.0 / static_cast<double>(hands_.size()));
    const S low = clamp((S(points_.hand_hangs) - hand.y) * S(per_drop_), S(0), S(1));
    const S share = S(kMassLevel) + low * S(kMassLow - kMassLevel);
    const S x = hand.x - S(points_.ankles.x);
    const S z = hand.z - S(points_.ankles.z);
    const S far = sqrt(x * x + z * z);
    const S goes = max(share * far - low * S(kMassLow * kMassNear), S(0)) / max(far, S(1e-6));
    const S off = frame.centre_of_mass.z - S(points_.home_mass.z) - z * goes;
    const S aside = (frame.centre_of_mass.x - S(points_.home_mass.x) - x * goes) * low;
    off_ = (off * off + aside * aside) * S(per_square_);
  }

  [[nodiscard]] S penalty() const { return off_ / (S(1) + off_); }

 private:
  PosturePoints points_;
  std::vector<GoalHand> hands_;
  double per_drop_;    // 1/m
  double per_square_;  // 1/m²
  S off_{};            // of the last frame seen
};

}  // namespace shigusa
