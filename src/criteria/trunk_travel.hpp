// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"
#include "criteria/posture_points.hpp"

namespace shigusa {

// Share of the arm's length from which the trunk joins a reach: people lean before they must (Mark
// et al., J. Exp. Psychology: HPP 23 (1997) 1365).
inline constexpr double kArmAlone = 0.92;

// Penalty of a reaching arm's shoulder that ends farther from its home position, in a standing
// person, than the goal requires, in [0, 1): within the arm's length the trunk keeps out of a reach
// (Kaminski, Bock and Gentile, Exp. Brain Res. 106 (1995) 457), beyond it the trunk covers the
// rest, and a stooped person stands up. With m the distance of the shoulder from home, n that of
// the hand's final position beyond 0.92 arms, and q = mean ((m - n) / distance)² over the goals'
// hands, P = q / (1 + q).
template <class S>
class TrunkTravel {
 public:
  static constexpr CriterionKind kKind = CriterionKind::trunk_travel;

  TrunkTravel(const BodyModel& body, const CriteriaContext& context, double distance)
      : hands_(goal_hands(body, context)), per_distance_(1.0 / distance) {}

  void reset() { off_ = S(0); }

  void add(const PlacedFrame<S>& frame) {
    S sum(0);
    for (const GoalHand& goal : hands_) {
      const Vec3<S> home = to_scalar<S>(goal.home);
      const S far = norm(goal.hand.in(frame.kinematics) - home);
      const S needed = max(far - S(kArmAlone * goal.arm), S(0));
      const S way = norm(goal.shoulder.in(frame.kinematics) - home);
      const S more = (way - needed) * S(per_distance_);
      sum = sum + more * more;
    }
    off_ = sum;
  }

  [[nodiscard]] S penalty() const {
    if (hands_.empty()) return S(0);
    const S off = off_ * S(1.0 / static_cast<double>(hands_.size()));
    return off / (S(1) + off);
  }

 private:
  std::vector<GoalHand> hands_;
  double per_distance_;  // 1/m
  S off_{};              // of the last frame seen
};

}  // namespace shigusa
