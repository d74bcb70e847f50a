// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>

#include "criteria/mean_and_worst.hpp"
#include "criteria/motion_frame.hpp"

namespace shigusa {

// Midpoint of the standing feet's soles (m, world) in the start posture; feet stay planted.
[[nodiscard]] Vec3d support_centre(const BodyModel& body);

// Penalty of the lean of the centre of mass c from above the support centre f, in [0, 1] (paper,
// section 3.3; rule R8b):
//   r(t) = |c - f|_horizontal / (c - f)_vertical,   P = min(1, (½ mean_t r + ½ max_t r) / lean).
template <class S>
class Balance {
 public:
  using Settings = BalanceSettings;

  explicit Balance(const BodyModel& body, const BalanceSettings& settings = {})
      : support_(to_scalar<S>(support_centre(body))), lean_(settings.lean) {}

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
