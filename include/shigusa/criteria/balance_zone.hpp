// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <shigusa/criteria/motion_frame.hpp>
#include <shigusa/motion/motion.hpp>
#include <vector>

namespace shigusa {

// What people keep between the plumb line of their centre of mass and the edge of what they stand
// on (m): some 2 to 3 cm.
inline constexpr double kBalanceReserve = 0.03;

struct BalanceZoneSettings {
  double margin = kBalanceReserve;  // m, > 0
};

// Corners (m, world) of what the planted feet stand on: the convex hull of their soles in the start
// posture, counter-clockwise from above. Empty for a body without feet.
[[nodiscard]] std::vector<Vec3d> support_polygon(const BodyModel& body);

// One edge of the support polygon: `offset + x · p.x + z · p.z` is how far (m) a point p lies
// inside, less than 0 outside.
struct SupportEdge {
  double x = 0.0;
  double z = 0.0;
  double offset = 0.0;  // m
};
[[nodiscard]] std::vector<SupportEdge> support_edges(const BodyModel& body);

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
      : margin_(static_cast<T>(settings.margin)),
        per_width_(static_cast<T>(0.5 / settings.margin)) {
    for (const SupportEdge& edge : support_edges(body)) {
      edges_.push_back(
          {static_cast<T>(edge.x), static_cast<T>(edge.z), static_cast<T>(edge.offset)});
    }
  }

  // Forgets the frames seen.
  void reset() {
    sum_ = largest_ = S(0);
    frames_ = 0;
  }

  void add(const MotionFrame<S>& frame) {
    // how far outside the margin, of the edge that it is nearest to
    S outside(0);
    for (const Edge& edge : edges_) {
      const S inside =
          S(edge.offset) + S(edge.x) * frame.centre_of_mass.x + S(edge.z) * frame.centre_of_mass.z;
      outside = max(outside, S(margin_) - inside);
    }
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
  struct Edge {
    T x;
    T z;
    T offset;
  };

  std::vector<Edge> edges_;
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
