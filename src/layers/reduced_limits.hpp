// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "layers/layer.hpp"

namespace shigusa {

// Joint limits inside the weighted IK of a reduced body, after LimitGuard: a freedom that goes
// towards a limit gives way by a share that falls to 0 over the last kLimitMargin, and comes to
// rest there while others take over. It goes where it was pulled in the step before.
//
// The ankle of a leg that is a rod of variable length is at lean - shank(length): the lean of the
// leg's line, less what the knee turns the shank away from it. Both move it, so near its limit both
// give way: a leg that changes its length by ΔL leans by (1 - share) · d shank/dL · ΔL more, which
// leaves the share of what the length alone moves the ankle by.
class ReducedLimits {
 public:
  // Limits those of the freedoms `used` (dofs) that have limits. The body outlives it.
  ReducedLimits(const ReducedBody& body, std::span<const std::size_t> used);

  // Before a motion's first step; inverse (dofs): the weights far from limits.
  void reset(std::span<const double> inverse);
  // Before a frame's first step from q (dofs, rad or m): sets the inverse weights to step with.
  void soften(std::span<const double> q, std::span<double> inverse);
  // Adds to the columns of lengths in the Jacobian (rows × dofs) what they lean by.
  void lean_with_length(std::span<double> jacobian) const;
  // After a frame's first step: force (dofs) is Jᵀλ, change (dofs) what that step moved.
  void learn(std::span<const double> force, std::span<const double> change);
  // Adds to q what a change of lengths (dofs, m) leans by.
  void follow_length(std::span<const double> change, std::span<double> q) const;
  // Puts back what passed a limit all the same, and leaves the rest of the frame to the others.
  void hold(std::span<double> q, std::span<double> inverse) const;

 private:
  struct Limited {
    std::size_t dof = 0;
    const ReducedLimb* leg = nullptr;  // of a lean, whose limits are the ankle's
    double pull = 0.0;                 // the sign says to which limit it goes
    double share = 1.0;                // of what it wants that it gets now
    double slope = 0.0;                // rad/m, of the shank by the length now
  };

  [[nodiscard]] double shank(const ReducedLimb& leg, double length) const;
  // rad, by which the limits of a freedom are moved
  [[nodiscard]] double moved_by(const Limited& limited, std::span<const double> q) const;

  const ReducedBody* body_;
  std::vector<Limited> limited_;
  std::vector<double> free_;  // (dofs) inverse weights far from limits
};

}  // namespace shigusa
