// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/parameters.hpp>
#include <span>
#include <vector>

#include "kinematics/weighted_ik.hpp"
#include "layers/body_limbs.hpp"

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
// what three lengths' worth of path leave to choose is where the elbow goes. Holds its scratch
// memory: make one per thread. The arm outlives it.
class ArmRollout {
 public:
  explicit ArmRollout(const BodyModel& arm);

  // path (frames) m, of the hand from the shoulder in the trunk's frame, from the start posture's
  // place on. angles: (frames × kArmDofs) rad, the start posture first. Returns the largest
  // distance of the hand from the path (m).
  double run(std::span<const Vec3d> path, const ArmWeights& weights, std::vector<double>& angles);

 private:
  const BodyModel* arm_;
  Kinematics<double> placed_;
  IkWorkspace<double> ik_;
};

}  // namespace shigusa
