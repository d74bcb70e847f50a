// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>

#include "criteria/motion_frame.hpp"

namespace shigusa {

// Work (J) with the full penalty.
[[nodiscard]] double full_work(const BodyModel& body, double share);

// Penalty of the mechanical work of all joints, lifting and braking alike, in [0, 1]:
//   P = min(1, Σ_t Σ_i |τ_i q̇_i| Δt / (share · m g · stature)).
// Source: the absolute work of Berret et al., PLoS Computational Biology 7 (2011) e1002183. The
// lower cost of braking for a muscle is ignored.
template <class S>
class Work {
 public:
  static constexpr CriterionKind kKind = CriterionKind::work;

  Work(const BodyModel& body, const CriteriaContext&, double share)
      : per_full_(1.0 / full_work(body, share)) {}

  void reset() { work_ = S(0); }

  void add(const MotionFrame<S>& frame) {
    S power(0);
    for (std::size_t k = 0; k < frame.speeds.size(); ++k) {
      power = power + abs(frame.torques[k] * frame.speeds[k]);
    }
    work_ = work_ + power * S(frame.frame_time);
  }

  [[nodiscard]] S penalty() const { return min(S(1), work_ * S(per_full_)); }

 private:
  double per_full_;  // 1/J
  S work_{};         // J
};

}  // namespace shigusa
