// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "kinematics/weighted_ik.hpp"
#include "paper/layered_values.hpp"
#include "plan/body_limbs.hpp"

namespace shigusa {

// Dofs of an arm with forearm and wrist, for a hand with an orientation; without them it has
// kArmDofs.
inline constexpr int kTurningArmDofs = 7;

// An arm alone, on an upright, fixed trunk: the body of the layer below. The base's frame is that
// of the link that carries it, with the origin in the shoulder; its home is the body's start. It
// has kArmDofs, and links beyond the elbow keep their start posture; with `turning`, for an arm
// with a wrist, kTurningArmDofs.
[[nodiscard]] PosedBody arm_body(const BodyModel& body, const State& start, const BodyLimb& arm,
                                 bool turning = false);

// The body's dofs for those of an arm_body, in its order.
[[nodiscard]] std::vector<int> arm_dofs(const BodyLimb& arm, bool turning);

// Moves the hand of an arm_body along a path of any shape, by weighted IK with three steps per
// frame: the position of the hand leaves only the elbow's to choose. S is double, or a pack whose
// lanes have separate paths and weights. Owns scratch memory: one per thread. The arm outlives it.
template <class S>
class ArmRollout {
 public:
  explicit ArmRollout(const PosedBody& arm)
      : arm_(&arm.body), start_(arm.home.angles), placed_(*arm_), ik_(*arm_), q_(kArmDofs) {
    SHG_CHECK(arm_->dof_count() == kArmDofs, "an arm has four freedoms");
  }

  // Moves the hand along a path. path (frames) m, of the hand from the shoulder in the trunk's
  // frame, from its position in the start posture on. inverse_weights (kArmDofs): 0 where locked.
  // angles: (frames × kArmDofs) rad, the start posture first. Returns the largest distance of the
  // hand from the path (m).
  S run(std::span<const Vec3<S>> path, std::span<const S> inverse_weights, std::vector<S>& angles) {
    const Effector& hand = arm_->effectors()[0];
    Constraint<S> target{.link = hand.link, .point = to_scalar<Element<S>>(hand.point)};
    const IkSettings settings;
    angles.resize(path.size() * q_.size());
    for (std::size_t d = 0; d < q_.size(); ++d) angles[d] = q_[d] = S(start_[d]);
    forward_kinematics<S>(*arm_, q_, placed_);
    S worst(0);
    for (std::size_t f = 1; f < path.size(); ++f) {
      target.place = path[f];
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
      // a NaN counts as far off
      worst = select(miss < S(1e9), max(worst, miss), S(1e9));
      for (std::size_t d = 0; d < q_.size(); ++d) angles[f * q_.size() + d] = q_[d];
    }
    return worst;
  }

 private:
  static constexpr int kStepsPerFrame = 3;

  const BodyModel* arm_;
  std::span<const double> start_;  // (dofs) rad
  Kinematics<S> placed_;
  IkWorkspace<S> ik_;
  std::vector<S> q_;
};

// The inverse weights of an arm (kArmDofs), 0 where locked.
[[nodiscard]] std::vector<double> inverse_weights(const ArmWeights& weights);

}  // namespace shigusa
