// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>

#include "criteria/motion_frame.hpp"

namespace shigusa {

// Penalty of joint accelerations, in [0, 1]:
//   P = min(1, sqrt(mean_t mean_i q̈_i²) / acceleration).
// With work, joint accelerations predict people's reaches best (Berret et al., PLoS Computational
// Biology 7 (2011) e1002183, figure 8).
template <class S>
class JointAcceleration {
 public:
  static constexpr CriterionKind kKind = CriterionKind::joint_acceleration;

  JointAcceleration(const BodyModel&, const CriteriaContext&, double acceleration)
      : per_acceleration_(1.0 / acceleration) {}

  void reset() {
    sum_ = S(0);
    count_ = 0.0;
  }

  void add(const MotionFrame<S>& frame) {
    S squares(0);
    for (const S& acceleration : frame.accelerations) {
      squares = squares + acceleration * acceleration;
    }
    sum_ = sum_ + squares;
    count_ += static_cast<double>(frame.accelerations.size());
  }

  [[nodiscard]] S penalty() const {
    if (count_ == 0.0) return S(0);
    return min(S(1), sqrt(sum_ * S(1.0 / count_)) * S(per_acceleration_));
  }

 private:
  double per_acceleration_;
  S sum_{};
  double count_ = 0.0;  // accelerations seen
};

}  // namespace shigusa
