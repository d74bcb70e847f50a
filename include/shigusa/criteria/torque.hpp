// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <shigusa/criteria/motion_frame.hpp>
#include <shigusa/motion/motion.hpp>

namespace shigusa {

// Root mean square share of the joints' strength at which the penalty is full (rule R8c). It
// saturates there: torque is heavy-tailed.
inline constexpr double kTorqueShare = 0.6;

struct TorqueSettings {
  double share = kTorqueShare;  // of strength, > 0
};

// Torque that the whole motion takes, in [0, 1] (paper, section 3.3; rule R8c):
//   P = min(1, sqrt(mean_t mean_i (τ_i / τ_i^max)²) / share),
// τ_i^max being the strength in the direction of τ_i.
template <class S>
class Torque {
 public:
  explicit Torque(const BodyModel& body, const TorqueSettings& settings = {})
      : body_(&body), share_(settings.share) {}

  void add(const MotionFrame<S>& frame) {
    S squares(0);
    for (int i = 0; i < body_->dof_count(); ++i) {
      const Dof& dof = body_->dof(i);
      const S tau = frame.torques[static_cast<std::size_t>(i)];
      const S load =
          tau * select(tau > S(0), S(1.0 / dof.torque_positive), S(1.0 / dof.torque_negative));
      squares = squares + load * load;
    }
    sum_ = sum_ + squares * S(1.0 / body_->dof_count());
    frames_ += 1;
  }

  [[nodiscard]] S penalty() const {
    if (frames_ == 0) return S(0);
    return min(S(1), sqrt(sum_ * S(1.0 / frames_)) * S(1.0 / share_));
  }

 private:
  const BodyModel* body_;
  double share_;
  S sum_{};
  int frames_ = 0;
};

// The penalty of a whole motion.
[[nodiscard]] double torque_penalty(const BodyModel& body, const Motion& motion,
                                    const TorqueSettings& settings = {});

}  // namespace shigusa
