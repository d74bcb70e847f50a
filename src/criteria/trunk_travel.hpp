// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body_model.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"
#include "criteria/posture_points.hpp"

namespace shigusa {

// The trunk joins a reach from this share of the arm's length on: people lean before they must
// (Mark et al., J. Exp. Psychology: HPP 23 (1997) 1365).
inline constexpr double kArmAlone = 0.92;

// How much farther than its goal takes it a reaching arm's shoulder has gone where the motion ends,
// in [0, 1]: within the arm's length the trunk keeps out of a reach (Kaminski, Bock and Gentile,
// Exp. Brain Res. 106 (1995) 457), beyond it the trunk goes along by what the arm lacks. With m the
// way that the shoulder has gone, and n by how much the hand's end is farther from where the
// shoulder was than 0.92 arms, P = min(1, mean ((m - n) / distance)²) over the goals' hands.
template <class S>
class TrunkTravel {
 public:
  using Settings = TrunkTravelSettings;

  explicit TrunkTravel(const BodyModel& body, const TrunkTravelSettings& settings = {})
      : hands_(goal_hands(body, settings.effectors)),
        starts_(hands_.size()),
        per_distance_(1.0 / settings.distance) {}

  // Forgets the frames seen.
  void reset() {
    seen_ = false;
    penalty_ = S(0);
  }

  void add(const PlacedFrame<S>& frame) {
    S sum(0);
    for (std::size_t h = 0; h < hands_.size(); ++h) {
      const GoalHand& goal = hands_[h];
      const Vec3<S> shoulder = goal.shoulder.in(frame.kinematics);
      if (!seen_) starts_[h] = shoulder;
      const S far = norm(goal.hand.in(frame.kinematics) - starts_[h]);
      const S needed = max(far - S(kArmAlone * goal.arm), S(0));
      const S more = (norm(shoulder - starts_[h]) - needed) * S(per_distance_);
      sum = sum + more * more;
    }
    seen_ = true;
    penalty_ = sum;
  }

  [[nodiscard]] S penalty() const {
    if (hands_.empty()) return S(0);
    return min(S(1), penalty_ * S(1.0 / static_cast<double>(hands_.size())));
  }

 private:
  std::vector<GoalHand> hands_;
  std::vector<Vec3<S>> starts_;  // m, of the shoulders
  double per_distance_;
  bool seen_ = false;
  S penalty_{};  // of the last frame seen
};

}  // namespace shigusa
