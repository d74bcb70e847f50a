// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/mean_and_worst.hpp"
#include "criteria/motion_frame.hpp"

namespace shigusa {

// Strength of a man of 73 kg about L5/S1 (N·m), in extension and in flexion of the back.
inline constexpr double kBackExtension = 240.0;
inline constexpr double kBackFlexion = 150.0;
// The moment about L5/S1 as a share of that about the hips. With de Leva's masses, and arms hanging
// from the shoulders, the body above the hip joints has, with an upright trunk, a moment of mass of
// 0.227 m · body mass about them, and the body above L5/S1, 0.10 m higher, 0.172 m · body mass
// about that; the quotient is the same for a leaning trunk. It would be 0.82 at 0.07 m, 0.71 at
// 0.12 m.
inline constexpr double kBackShareOfHips = 0.76;

// The dofs whose torques are summed and compared with the lower back's strength: both hips'
// flexion, or that of a spine's lowest joint.
struct BackConstants {
  std::vector<int> dofs;
  double per_extension = 0.0;  // 1/(N·m), for negative torques
  double per_flexion = 0.0;    // 1/(N·m)
};
[[nodiscard]] BackConstants back_constants(const BodyModel& body);

// Penalty of the moment about the lateral axis of the lowest lumbar joint, L5/S1, squared, in [0,
// 1]:
//   r(t) = 0.76 · Σ τ_hip flexion / strength,   P = min(1, (½ mean_t r² + ½ max_t r²) / share²).
// A rigid trunk has no joint at L5/S1. But both hips flex about one line across the pelvis, and the
// sum of their torques is the moment, of weight and of inertia, of the body above them, of which
// L5/S1 bears a fixed share. Strength is the man's above, scaled by the ratio of the body's hips to
// his, which includes mass and sex. A body with a spine has the joint, and r is its torque by its
// strength. A body without hips has no penalty.
template <class S>
class LowBack {
 public:
  static constexpr CriterionKind kKind = CriterionKind::low_back;

  LowBack(const BodyModel& body, const CriteriaContext&, double share)
      : back_(back_constants(body)), per_square_(1.0 / (share * share)) {}

  void reset() { seen_.reset(); }

  void add(const MotionFrame<S>& frame) {
    S torque(0);
    for (const int d : back_.dofs) torque = torque + frame.torques[static_cast<std::size_t>(d)];
    const S load = torque * select(torque > S(0), S(back_.per_flexion), S(back_.per_extension));
    const S square = load * load;
    seen_.add(square);
  }

  [[nodiscard]] S penalty() const { return seen_.penalty(per_square_); }

 private:
  BackConstants back_;
  double per_square_;
  MeanAndWorst<S> seen_;
};

}  // namespace shigusa
