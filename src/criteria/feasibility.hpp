// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"
#include "criteria/support_zone.hpp"
#include "dynamics/inverse_dynamics.hpp"

namespace shigusa {

// Whether the body could make the motion at all, in [0, 1): 0 where every joint keeps to its
// strength and the floor can hold the body, and above it the more the worst moment asks for. With
//   e(t) = max(0, max_i τ_i / τ_i^max - 1, d(t) / outside),
// τ_i^max being the strength in the direction of τ_i and d(t) how far the centre of pressure would
// have to be outside the support polygon (see CentreOfPressure), P = e / (1 + e) with e = max_t
// e(t). It has no upper end: where nothing is possible, less is still better. Of a body without
// feet, or with feet of no size, strength alone counts.
template <class S>
class Feasibility {
 public:
  using Settings = FeasibilitySettings;

  explicit Feasibility(const BodyModel& body, const FeasibilitySettings& settings = {})
      : zone_(body),
        per_outside_(static_cast<T>(1.0 / (settings.outside * body.mass() * kGravity))) {
    for (const Dof& dof : body.dofs()) {
      strengths_.push_back(
          {static_cast<T>(1.0 / dof.torque_positive), static_cast<T>(-1.0 / dof.torque_negative)});
    }
  }

  // Forgets the frames seen.
  void reset() { worst_ = S(0); }

  void add(const PlacedFrame<S>& frame) {
    S most(0);
    for (std::size_t k = 0; k < strengths_.size(); ++k) {
      const S tau = frame.torques[k];
      // one of both is the share of its strength, the other one is below 0
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
    T per_negative;  // of torques below 0, < 0
  };

  std::vector<Strength> strengths_;  // (dofs)
  SupportZone<S> zone_;
  T per_outside_;
  S worst_{};
};

}  // namespace shigusa
