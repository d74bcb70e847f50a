// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "kinematics/weighted_ik.hpp"
#include "paper/layered_values.hpp"
#include "plan/body_limbs.hpp"

namespace shigusa {

// Freedoms of an arm with forearm and wrist, for a hand that turns; without them it has kArmDofs.
inline constexpr int kTurningArmDofs = 7;

// An arm alone, on a trunk that stands upright and does not move: the body of the layer below. The
// base's frame is that of the link that carries it with the origin in the shoulder; the arm starts
// as the body's does. It has kArmDofs, and holds what is beyond the elbow as it is at the start;
// `turning`, of an arm with a wrist: kTurningArmDofs.
[[nodiscard]] BodyModel arm_body(const BodyModel& body, const BodyLimb& arm, bool turning = false);

// The body's dofs that those of an arm_body are, in its order.
[[nodiscard]] std::vector<int> arm_dofs(const BodyLimb& arm, bool turning);

// Moves the hand of an arm_body along a path of any shape, by weighted IK with three steps a frame:
// what three lengths' worth of path leave to choose is where the elbow goes. S is double, or a
// pack: then each lane has a path and weights of its own. Holds its scratch memory: make one per
// thread. The arm outlives it.
template <class S>
class ArmRollout {
 public:
  explicit ArmRollout(const BodyModel& arm) : arm_(&arm), placed_(arm), ik_(arm), q_(kArmDofs) {
    SHG_CHECK(arm.dof_count() == kArmDofs, "an arm has four freedoms");
  }

  // path (frames) m, of the hand from the shoulder in the trunk's frame, from the start posture's
  // place on. inverse_weights (kArmDofs): 0 where locked. angles: (frames × kArmDofs) rad, the
  // start posture first. Returns the largest distance of the hand from the path (m).
  S run(std::span<const Vec3<S>> path, std::span<const S> inverse_weights, std::vector<S>& angles) {
    const Effector& hand = arm_->effectors()[0];
    IkTarget<S> target{.link = hand.link, .point = to_scalar<Element<S>>(hand.point)};
    const IkSettings settings;
    angles.resize(path.size() * q_.size());
    for (std::size_t d = 0; d < q_.size(); ++d) angles[d] = q_[d] = S(arm_->start()[d]);
    forward_kinematics<S>(*arm_, q_, placed_);
    S worst(0);
    for (std::size_t f = 1; f < path.size(); ++f) {
      target.position = path[f];
      S miss(0);
      const int most = f + 1 == path.size() ? kStepsPerFrame + kLastSteps : kStepsPerFrame;
      for (int k = 0; k < most && (k < kStepsPerFrame || any(miss > S(kLastMiss<S>))); ++k) {
        const std::span<const S> change = weighted_ik_step<S>(
            *arm_, placed_, {std::span(&target, 1), inverse_weights}, settings, ik_);
        const auto off = S(k < kStepsPerFrame ? 1.0 : 0.0) + miss > S(kLastMiss<S>);
        for (std::size_t d = 0; d < q_.size(); ++d) q_[d] = select(off, q_[d] + change[d], q_[d]);
        forward_kinematics<S>(*arm_, q_, placed_);
        miss = norm(position_error(placed_, target));
      }
      target.lag = miss;
      // NaN counts as far off
      worst = select(miss < S(1e9), max(worst, miss), S(1e9));
      for (std::size_t d = 0; d < q_.size(); ++d) angles[f * q_.size() + d] = q_[d];
    }
    return worst;
  }

 private:
  static constexpr int kStepsPerFrame = 3;

  const BodyModel* arm_;
  Kinematics<S> placed_;
  IkWorkspace<S> ik_;
  std::vector<S> q_;
};

// The inverse weights of an arm (kArmDofs), 0 where locked.
[[nodiscard]] std::vector<double> inverse_weights(const ArmWeights& weights);

}  // namespace shigusa
