// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body_model.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "criteria/motion_frame.hpp"

namespace shigusa {

// A torque that changes by this share of the joint's strength, both ways together, from one frame
// of a motion to the next is a jolt as large as …
inline constexpr double kTorqueJolt = 0.30;
// … a floor's pressure that moves by this (m).
inline constexpr double kPressureJolt = 0.03;

// The greatest change of a torque or of the floor's pressure from one frame to the next, in [0, 1].
// With t the change of a joint's torque over 0.30 of its strength both ways, and c the way of the
// centre of pressure over 0.03 m, P = min(1, (max (t, c) / limit)⁴): of no weight until near the
// limit.
template <class S>
class Jolts {
 public:
  using Settings = JoltsSettings;

  explicit Jolts(const BodyModel& body, const JoltsSettings& settings = {})
      : before_(body.dofs().size()), per_limit_(1.0 / settings.limit) {
    for (const Dof& dof : body.dofs()) {
      per_strength_.push_back(
          static_cast<T>(1.0 / (kTorqueJolt * (dof.torque_positive + dof.torque_negative))));
    }
  }

  // Forgets the frames seen.
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
    const S force = max(frame.pressure.y, S(1e-3));
    const S x = frame.pressure.x / force;
    const S z = frame.pressure.z / force;
    if (seen_) {
      const S along = x - x_;
      const S across = z - z_;
      const S moved = (along * along + across * across) * S(kPerPressure * kPerPressure);
      square_ = max(square_, max(worst * worst, moved));
    }
    x_ = x;
    z_ = z;
    seen_ = true;
  }

  [[nodiscard]] S penalty() const {
    const S share = square_ * S(per_limit_ * per_limit_);
    return min(S(1), share * share);
  }

 private:
  using T = Element<S>;
  static constexpr double kPerPressure = 1.0 / kPressureJolt;

  std::vector<T> per_strength_;  // (dofs) 1/(N·m)
  std::vector<S> before_;        // (dofs) N·m
  double per_limit_;
  bool seen_ = false;
  S x_{};  // m, of the pressure
  S z_{};
  S square_{};  // of the greatest change
};

}  // namespace shigusa
