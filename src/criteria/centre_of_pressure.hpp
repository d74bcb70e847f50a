// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>

#include "criteria/motion_frame.hpp"
#include "criteria/support_zone.hpp"
#include "dynamics/inverse_dynamics.hpp"

namespace shigusa {

// Penalty of motions that need a floor reaction outside the feet's support polygon, in [0, 1]: no
// floor provides it, and the body would tip over the edge of its feet, wherever its centre of mass
// is. With d(t) the largest tipping moment about an edge, 0 where the floor can hold the body, as a
// share of the body's weight times `outside`, clamped to 1: P = √ mean_t d². Where the floor bears
// the body's weight, d is the distance of the centre of pressure outside. A body without feet, or
// with feet of no size, has no penalty.
//
// Source: the condition that a zero-moment point stays in the support polygon, M. Vukobratović and
// B. Borovac, Int. J. Humanoid Robotics 1 (2004) 157-173.
template <class S>
class CentreOfPressure {
 public:
  static constexpr CriterionKind kKind = CriterionKind::centre_of_pressure;

  CentreOfPressure(const BodyModel& body, const CriteriaContext& context, double outside)
      : zone_(body, context.start),
        per_outside_(static_cast<T>(1.0 / (outside * body.mass() * kGravity))) {}

  void reset() {
    squares_ = S(0);
    frames_ = 0;
  }

  void add(const PlacedFrame<S>& frame) {
    const S tips = max(S(0), -zone_.inside(frame.pressure, frame.angles));  // N·m
    const S share = min(tips * S(per_outside_), S(1));
    squares_ = squares_ + share * share;
    frames_ += 1;
  }

  [[nodiscard]] S penalty() const {
    return frames_ == 0 ? S(0) : min(S(1), sqrt(squares_ * S(1.0 / frames_)));
  }

 private:
  using T = Element<S>;

  SupportZone<S> zone_;
  T per_outside_;
  S squares_{};
  int frames_ = 0;
};

}  // namespace shigusa
