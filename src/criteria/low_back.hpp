// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/mean_and_worst.hpp"
#include "criteria/motion_frame.hpp"

namespace shigusa {

// Strength of a man of 73 kg about L5/S1 (N·m): straightening the back, and bending it forwards.
inline constexpr double kBackExtension = 240.0;
inline constexpr double kBackFlexion = 150.0;
// The moment about L5/S1 as a share of that about the hips. With de Leva's masses, and arms that
// hang from the shoulders, all that is above the hip joints of an upright trunk has its moment of
// mass 0.227 m · body mass above them, and what is above L5/S1, 0.10 m higher, has 0.172 m · body
// mass above that; the quotient stays when the trunk leans. 0.82 were it 0.07 m higher, 0.71 at
// 0.12 m.
inline constexpr double kBackShareOfHips = 0.76;

// The dofs whose torques' sum is compared with the lower back's strength: both hips' flexion,
// or the lowest joint's of a spine.
struct BackConstants {
  std::vector<int> dofs;
  double per_extension = 0.0;  // 1/(N·m), of torques less than 0
  double per_flexion = 0.0;    // 1/(N·m)
};
[[nodiscard]] BackConstants back_constants(const BodyModel& body);

// Moment about the lateral axis of the lowest lumbar joint, L5/S1, squared, in [0, 1]:
//   r(t) = 0.76 · Σ τ_hip flexion / strength,   P = min(1, (½ mean_t r² + ½ max_t r²) / share²).
// Where the trunk is rigid, no joint of the body is L5/S1. But both hips flex about one line across
// the pelvis, and their torques together are the moment, of weight and of inertia, of all that
// stands on them; L5/S1 bears a fixed share of it. Strength is the man's above, by the ratio of the
// body's hips to his: mass and sex are in there. A body with a spine has the joint, and r is its
// torque by its strength. A body without hips has no penalty.
template <class S>
class LowBack {
 public:
  using Settings = LowBackSettings;

  explicit LowBack(const BodyModel& body, const LowBackSettings& settings = {})
      : back_(back_constants(body)), per_square_(1.0 / (settings.share * settings.share)) {}

  // Forgets the frames seen.
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
