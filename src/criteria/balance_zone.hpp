// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>

#include "criteria/mean_and_worst.hpp"
#include "criteria/motion_frame.hpp"
#include "criteria/support_zone.hpp"

namespace shigusa {

// Penalty of a plumb line from the centre of mass near or beyond the edge of the feet's support
// polygon, in [0, 1]. Positions well inside are all equal: in people's reaches the plumb line
// wanders (Stapley et al., Biological Cybernetics 82 (2000) 161).
//   p(t) = (margin - d(t)) / (2 margin), clamped to [0, 1];   P = ½ mean_t p + ½ max_t p,
// with d the distance to the nearest edge, negative outside: 0 from `margin` inside on, ½ at the
// edge, 1 from `margin` outside on. Near a corner, outside, d is the distance to the nearest edge's
// line. A body without feet, or with feet of no size, has no penalty.
template <class S>
class BalanceZone {
 public:
  static constexpr CriterionKind kKind = CriterionKind::balance_zone;

  BalanceZone(const BodyModel& body, const CriteriaContext& context, double margin)
      : zone_(body, context.start),
        margin_(static_cast<T>(margin)),
        per_width_(static_cast<T>(0.5 / margin)) {}

  void reset() { seen_.reset(); }

  void add(const MotionFrame<S>& frame) {
    const Vec3<S>& c = frame.centre_of_mass;
    const S inside = zone_.inside({c.x, S(1), c.z}, frame.angles);
    // distance outside the margin of the nearest edge
    const S outside = max(S(0), S(margin_) - inside);
    const S share = min(outside * S(per_width_), S(1));
    seen_.add(share);
  }

  [[nodiscard]] S penalty() const { return seen_.penalty(); }

 private:
  using T = Element<S>;

  SupportZone<S> zone_;
  T margin_;
  T per_width_;
  MeanAndWorst<S> seen_;
};

}  // namespace shigusa
