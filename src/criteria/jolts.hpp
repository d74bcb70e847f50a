// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"

namespace shigusa {

// Change of a torque within a sixtieth of a second that counts as one jolt, as a share of the
// joint's strengths in both directions together.
inline constexpr double kTorqueJolt = 0.30;
// Displacement (m) of the centre of pressure that counts as one jolt.
inline constexpr double kPressureJolt = 0.03;
inline constexpr double kJoltTime = 1.0 / 60.0;  // s

// Penalty of the most sudden change of a torque or of the floor's pressure, in [0, 1). With t the
// change of a joint's torque over 0.30 of its strength both ways, c the displacement of the centre
// of pressure over 0.03 m, both within 1/60 s, and q = (max (t, c) / limit)⁴, P = q / (1 + q):
// small until near the limit. A body without feet has no pressure.
template <class S>
class Jolts {
 public:
  static constexpr CriterionKind kKind = CriterionKind::jolts;

  Jolts(const BodyModel& body, const CriteriaContext&, double limit)
      : before_(body.dofs().size()), per_limit_(1.0 / limit), stands_(!body.feet().empty()) {
    for (const Dof& dof : body.dofs()) {
      per_strength_.push_back(
          static_cast<T>(1.0 / (kTorqueJolt * (dof.torque_positive + dof.torque_negative))));
    }
  }

  void reset() {
    seen_ = false;
    square_ = S(0);
  }

  void add(const PlacedFrame<S>& frame) {
    S worst(0);
    for (std::size_t d = 0; d < before_.size(); ++d) {
      worst = max(worst, abs(frame.torques[d] - before_[d]) * S(per_strength_[d]));
      before_[d] = frame.torques[d];
    }
    S square = worst * worst;
    if (stands_) {
      const S force = max(frame.pressure.y, S(1e-3));
      const S x = frame.pressure.x / force;
      const S z = frame.pressure.z / force;
      const S along = (x - x_) * S(kPerPressure);
      const S across = (z - z_) * S(kPerPressure);
      square = max(square, along * along + across * across);
      x_ = x;
      z_ = z;
    }
    const double in_jolt_time = kJoltTime / frame.frame_time;
    if (seen_) square_ = max(square_, square * S(in_jolt_time * in_jolt_time));
    seen_ = true;
  }

  [[nodiscard]] S penalty() const {
    // the square for a falling body would overflow single precision
    const S square = min(square_ * S(per_limit_ * per_limit_), S(1e6));
    const S off = square * square;
    return off / (S(1) + off);
  }

 private:
  using T = Element<S>;
  static constexpr double kPerPressure = 1.0 / kPressureJolt;

  std::vector<T> per_strength_;  // (dofs) 1/(N·m)
  std::vector<S> before_;        // (dofs) N·m
  double per_limit_;
  bool stands_;
  bool seen_ = false;
  S x_{};  // m, centre of pressure
  S z_{};
  S square_{};  // square of the greatest change, in jolts
};

}  // namespace shigusa
