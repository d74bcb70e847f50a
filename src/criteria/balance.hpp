// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>

#include "criteria/mean_and_worst.hpp"
#include "criteria/motion_frame.hpp"

namespace shigusa {

// Midpoint of the standing feet's soles (m, world) at the start of the motion; feet stay planted.
[[nodiscard]] Vec3d support_centre(const BodyModel& body, const State& start);

// Penalty of the lean of the centre of mass c from above the support centre f, in [0, 1] (paper,
// section 3.3; rule R8b):
//   r(t) = |c - f|_horizontal / (c - f)_vertical,   P = min(1, (½ mean_t r + ½ max_t r) / lean).
template <class S>
class Balance {
 public:
  static constexpr CriterionKind kKind = CriterionKind::balance;

  Balance(const BodyModel& body, const CriteriaContext& context, double lean)
      : support_(to_scalar<S>(support_centre(body, context.start))), lean_(lean) {}

  void reset() { seen_.reset(); }

  void add(const MotionFrame<S>& frame) {
    const Vec3<S> d = frame.centre_of_mass - support_;
    // a centre of mass at or below the floor has an unbounded lean
    const S ratio = sqrt(d.x * d.x + d.z * d.z) / max(d.y, S(1e-3));
    seen_.add(ratio);
  }

  [[nodiscard]] S penalty() const { return seen_.penalty(1.0 / lean_); }

 private:
  Vec3<S> support_;
  double lean_;
  MeanAndWorst<S> seen_;
};

}  // namespace shigusa
