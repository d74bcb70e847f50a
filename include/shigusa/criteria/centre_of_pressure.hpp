// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria/balance_zone.hpp>
#include <shigusa/criteria/motion_frame.hpp>
#include <shigusa/motion/motion.hpp>
#include <vector>

namespace shigusa {

// How far outside the support polygon (m) the penalty is full.
inline constexpr double kPressureOutside = 0.15;

struct PressureSettings {
  double outside = kPressureOutside;  // m, > 0
};

// How far the motion would have the floor's force outside what the feet stand on, in [0, 1]: no
// floor gives that, and the body would tip over the edge of its feet, however well its centre of
// mass stands. With d(t) the distance (m) from the support polygon to the centre of pressure that
// the motion asks for, 0 inside, as a share of `outside`, held to 1:  P = ½ mean_t d + ½ max_t d.
// Near a corner d is the distance to the nearest edge's line. A body without feet, or with feet of
// no size, has no penalty.
//
// Source: the condition that a zero-moment point stays in the support polygon, M. Vukobratović and
// B. Borovac, Int. J. Humanoid Robotics 1 (2004) 157-173.
template <class S>
class PressureZone {
 public:
  explicit PressureZone(const BodyModel& body, const PressureSettings& settings = {})
      : per_outside_(static_cast<T>(1.0 / settings.outside)) {
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
    S outside(0);
    for (const Edge& edge : edges_) {
      const Vec3<S>& at = frame.centre_of_pressure;
      outside = max(outside, -(S(edge.offset) + S(edge.x) * at.x + S(edge.z) * at.z));
    }
    const S share = min(outside * S(per_outside_), S(1));
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
  T per_outside_;
  S sum_{};
  S largest_{};
  int frames_ = 0;
};

// The penalty of a whole motion.
[[nodiscard]] double pressure_penalty(const BodyModel& body, const Motion& motion,
                                      const PressureSettings& settings = {});

}  // namespace shigusa
