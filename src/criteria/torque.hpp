// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"

namespace shigusa {

// Penalty of the torques of the whole motion, in [0, 1] (paper, section 3.3; rule R8c):
//   P = min(1, sqrt(mean_t mean_i (τ_i / τ_i^max)²) / share),
// with τ_i^max the strength in the direction of τ_i.
template <class S>
class Torque {
 public:
  static constexpr CriterionKind kKind = CriterionKind::torque;

  Torque(const BodyModel& body, const CriteriaContext&, double share)
      : per_share_(static_cast<T>(1.0 / share)) {
    for (const Dof& dof : body.dofs()) {
      strengths_.push_back(
          {static_cast<T>(1.0 / dof.torque_positive), static_cast<T>(1.0 / dof.torque_negative)});
    }
  }

  void reset() {
    sum_ = S(0);
    frames_ = 0;
  }

  void add(const MotionFrame<S>& frame) {
    S squares(0);
    for (std::size_t k = 0; k < strengths_.size(); ++k) {
      const S tau = frame.torques[k];
      const S load =
          tau * select(tau > S(0), S(strengths_[k].per_positive), S(strengths_[k].per_negative));
      squares = squares + load * load;
    }
    sum_ = sum_ + squares;
    frames_ += 1;
  }

  [[nodiscard]] S penalty() const {
    if (frames_ == 0) return S(0);
    const double count = static_cast<double>(strengths_.size()) * frames_;
    return min(S(1), sqrt(sum_ * S(1.0 / count)) * S(per_share_));
  }

 private:
  using T = Element<S>;
  struct Strength {
    T per_positive;  // 1/(N·m)
    T per_negative;
  };

  std::vector<Strength> strengths_;  // (dofs)
  T per_share_;
  S sum_{};
  int frames_ = 0;
};

}  // namespace shigusa
