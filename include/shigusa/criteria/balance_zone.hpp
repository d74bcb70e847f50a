// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <shigusa/criteria/motion_frame.hpp>
#include <shigusa/criteria/support_zone.hpp>
#include <shigusa/motion/motion.hpp>

namespace shigusa {

// What people keep between the plumb line of their centre of mass and the edge of what they stand
// on (m): some 2 to 3 cm.
inline constexpr double kBalanceReserve = 0.03;

struct BalanceZoneSettings {
  double margin = kBalanceReserve;  // m, > 0
};

// How near the centre of mass's plumb line comes to the edge of the feet's support polygon, or how
// far it leaves it, in [0, 1]. Anywhere well inside is as good as the middle: people who reach let
// it wander (Stapley et al., Biological Cybernetics 82 (2000) 161).
//   p(t) = (margin - d(t)) / (2 margin), held to [0, 1];   P = ½ mean_t p + ½ max_t p,
// d being the distance to the nearest edge, less than 0 outside: 0 from `margin` inside on, ½ at
// the edge, 1 from `margin` outside on. Near a corner, outside, d is the distance to the nearest
// edge's line. A body without feet, or with feet of no size, has no penalty.
template <class S>
class BalanceZone {
 public:
  explicit BalanceZone(const BodyModel& body, const BalanceZoneSettings& settings = {})
      : zone_(body),
        margin_(static_cast<T>(settings.margin)),
        per_width_(static_cast<T>(0.5 / settings.margin)) {}

  // Forgets the frames seen.
  void reset() {
    sum_ = largest_ = S(0);
    frames_ = 0;
  }

  void add(const MotionFrame<S>& frame) {
    const Vec3<S>& c = frame.centre_of_mass;
    const S inside = zone_.inside({c.x, S(1), c.z}, frame.angles);
    // how far outside the margin, of the edge that it is nearest to
    const S outside = max(S(0), S(margin_) - inside);
    const S share = min(outside * S(per_width_), S(1));
    sum_ = sum_ + share;
    largest_ = max(largest_, share);
    frames_ += 1;
  }

  [[nodiscard]] S penalty() const {
    if (frames_ == 0) return S(0);
    return min(S(1), sum_ * S(0.5 / frames_) + largest_ * S(0.5));
  }

 private:
  using T = Element<S>;

  SupportZone<S> zone_;
  T margin_;
  T per_width_;
  S sum_{};
  S largest_{};
  int frames_ = 0;
};

// The penalty of a whole motion.
[[nodiscard]] double balance_zone_penalty(const BodyModel& body, const Motion& motion,
                                          const BalanceZoneSettings& settings = {});

}  // namespace shigusa
