// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"
#include "criteria/support_zone.hpp"
#include "dynamics/inverse_dynamics.hpp"

namespace shigusa {

// Penalty of motions that the body cannot make, in [0, 1): 0 if every joint keeps to its strength
// and the floor can hold the body, otherwise increasing with the excess of the worst moment. With
//   e(t) = max(0, max_i τ_i / τ_i^max - 1, d(t) / outside),
// with τ_i^max the strength in the direction of τ_i and d(t) the distance of the required centre of
// pressure outside the support polygon (see CentreOfPressure), P = e / (1 + e) and e = max_t e(t).
// It is unbounded in e: among impossible motions, a smaller excess is still better. For a body
// without feet, or with feet of no size, only strength counts.
template <class S>
class Feasibility {
 public:
  static constexpr CriterionKind kKind = CriterionKind::feasibility;

  Feasibility(const BodyModel& body, const CriteriaContext& context, double outside)
      : zone_(body, context.start),
        per_outside_(static_cast<T>(1.0 / (outside * body.mass() * kGravity))) {
    for (const Dof& dof : body.dofs()) {
      strengths_.push_back(
          {static_cast<T>(1.0 / dof.torque_positive), static_cast<T>(-1.0 / dof.torque_negative)});
    }
  }

  void reset() { worst_ = S(0); }

  void add(const PlacedFrame<S>& frame) {
    S most(0);
    for (std::size_t k = 0; k < strengths_.size(); ++k) {
      const S tau = frame.torques[k];
      // the one that is not negative is the share of the strength
      most =
          max(most, max(tau * S(strengths_[k].per_positive), tau * S(strengths_[k].per_negative)));
    }
    const S tips = -zone_.inside(frame.pressure, frame.angles) * S(per_outside_);
    worst_ = max(worst_, max(most - S(1), tips));
  }

  [[nodiscard]] S penalty() const { return worst_ / (S(1) + worst_); }

 private:
  using T = Element<S>;
  struct Strength {
    T per_positive;  // 1/(N·m)
    T per_negative;  // for negative torques, < 0
  };

  std::vector<Strength> strengths_;  // (dofs)
  SupportZone<S> zone_;
  T per_outside_;
  S worst_{};
};

}  // namespace shigusa
