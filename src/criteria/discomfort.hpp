// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>
#include <vector>

#include "body/coupled_limits.hpp"
#include "criteria/mean_and_worst.hpp"
#include "criteria/motion_frame.hpp"

namespace shigusa {

// Last share of the range from neutral to a limit, in which discomfort rises steeply.
inline constexpr double kDiscomfortEnd = 0.12;
// Share of the range below which a limit counts as the joint's neutral position: knees and elbows
// are straight there.
inline constexpr double kRestingShare = 0.10;

// Penalty of joints far from neutral and near the ends of their range, in [0, 1]. Neutral is
// upright with hanging arms, all angles 0. With u the share of the range from neutral to the limit
// on that side, 1 at the limit and beyond:
//   d(u) = ½ u² + ½ (max(0, u - 0.88) / 0.12)²,   D(t) = mean_i d(u_i(t)),
//   P = min(1, (½ mean_t D + ½ max_t D) / share).
// Upper limits depend on the body's couplings. Both terms are those of joint discomfort in
// Abdel-Malek and Arora, Human Motion Simulation (2013), equations 3.13 to 3.16: a square about
// neutral, and at either end a term that stays at 0 until the last tenth or so of the range; its (½
// sin + 1)^100, over its own maximum, agrees with this parabola within 0.16. The weights by groups
// of joints are omitted.
template <class S>
class Discomfort {
 public:
  static constexpr CriterionKind kKind = CriterionKind::discomfort;

  Discomfort(const BodyModel& body, const CriteriaContext&, double share)
      : per_share_(1.0 / share), coupled_(body) {
    for (const Dof& dof : body.dofs()) {
      const double neutral = clamp_to(0.0, dof.lower, dof.upper);
      const double resting = kRestingShare * (dof.upper - dof.lower);
      const double up = dof.upper - neutral;
      const double down = neutral - dof.lower;
      ranges_.push_back({static_cast<T>(neutral), static_cast<T>(up),
                         static_cast<T>(up > resting ? 1.0 / up : 0.0),
                         static_cast<T>(down > resting ? 1.0 / down : 0.0), false});
    }
    for (const std::size_t d : coupled_.coupled()) ranges_[d].coupled = ranges_[d].per_up > T(0);
  }

  void reset() { seen_.reset(); }

  void add(const MotionFrame<S>& frame) {
    coupled_.update(frame.angles);
    S discomfort(0);
    for (std::size_t k = 0; k < ranges_.size(); ++k) {
      const Range& range = ranges_[k];
      const S per_up = range.coupled ? S(1) / (S(range.up) + coupled_.added()[k]) : S(range.per_up);
      const S from_neutral = frame.angles[k] - S(range.neutral);
      const S u = clamp(max(from_neutral * per_up, -from_neutral * S(range.per_down)), S(0), S(1));
      const S end = max(u - S(1.0 - kDiscomfortEnd), S(0)) * S(1.0 / kDiscomfortEnd);
      discomfort = discomfort + (u * u + end * end);
    }
    seen_.add(discomfort);
  }

  [[nodiscard]] S penalty() const {
    // half of each of the two terms
    return seen_.penalty(0.5 * per_share_ / static_cast<double>(ranges_.size()));
  }

 private:
  using T = Element<S>;
  struct Range {
    T neutral;   // rad
    T up;        // rad, to the upper limit
    T per_up;    // 1/rad; 0 if the limit is the neutral position
    T per_down;  // 1/rad
    bool coupled;
  };
  static double clamp_to(double x, double low, double high) {
    return x < low ? low : x > high ? high : x;
  }

  double per_share_;
  std::vector<Range> ranges_;  // (dofs)
  CoupledLimits<S> coupled_;
  MeanAndWorst<S> seen_;
};

}  // namespace shigusa
