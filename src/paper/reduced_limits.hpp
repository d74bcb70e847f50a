// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/index.hpp"
#include "kinematics/weighted_ik.hpp"
#include "paper/reduced_problem.hpp"
#include "rollout/limit_guard.hpp"

namespace shigusa {

// Cap (rad/m) on the shank's turn per change of the leg's length, which is unbounded as the knee
// straightens, where the ankle is far from its limits.
inline constexpr double kMostShankTurn = 20.0;
// Margin of an ankle's limits: it carries the whole body, and a squat takes it to its limit fast,
// so a smaller margin would stop it with a jerk.
inline constexpr double kAnkleMargin = radians(20.0);

// Joint limits inside the weighted IK of a reduced body, after LimitGuard: a dof that moves towards
// a limit yields by a share that falls to 0 over the last kLimitMargin, and comes to rest there
// while others take over. The direction is that of the pull in the step before.
//
// The ankle of a leg that is a rod of variable length is at lean - shank(length): the lean of the
// leg's line, less the angle of the shank to it by the knee. Both move it, so near its limit both
// yield: a leg that changes its length by ΔL leans by (1 - share) · d shank/dL · ΔL more, which
// leaves the share of the ankle's motion by the length alone.
template <class S>
class ReducedLimits {
 public:
  // The problem outlives the object.
  explicit ReducedLimits(const ReducedProblem& problem)
      : body_(problem.body), free_(problem.dofs().size()) {
    for (const int d : problem.limited) {
      Limited limited{.dof = index(d)};
      for (const ReducedLimb& limb : body_->limbs) {
        if (limb.lean != d) continue;
        limited.slide = index(limb.slide);
        limited.leg.emplace(limb.joints.segments);
      }
      limited_.push_back(limited);
    }
  }

  [[nodiscard]] bool empty() const { return limited_.empty(); }

  // Resets the state before a motion's first step; inverse (dofs): the weights far from limits.
  void reset(std::span<const S> inverse) {
    for (std::size_t d = 0; d < free_.size(); ++d) free_[d] = inverse[d];
    for (Limited& limited : limited_) limited.pull = S(0);
  }

  // Sets the inverse weights for a frame's first step from q (dofs, rad or m).
  void soften(std::span<const S> q, std::span<S> inverse) {
    for (Limited& limited : limited_) {
      const ReducedDof& dof = body_->dofs[limited.dof];
      const S angle = q[limited.dof] - moved_by(limited, q);
      const S room = select(limited.pull > S(0), S(dof.upper) - angle, angle - S(dof.lower));
      const S margin(limited.leg ? kAnkleMargin : kLimitMargin);
      const auto pulled = (limited.pull > S(0)) | (limited.pull < S(0));
      const S t = select(pulled, clamp(room / margin, S(0), S(1)), S(1));
      limited.share = t * t * (S(3) - S(2) * t);
      inverse[limited.dof] = free_[limited.dof] * limited.share;
      if (!limited.leg) continue;
      limited.slope = limited.leg->turn_by_length(q[limited.slide], kMostShankTurn);
    }
  }

  // Adds the lean that goes with the lengths to their columns in a Jacobian's block of that chain.
  void lean_with_length(std::span<const int> chain, std::span<Vec3<S>> columns) const {
    for (const Limited& limited : limited_) {
      if (!limited.leg || !contains(chain, limited.slide)) continue;
      columns[limited.slide] += columns[limited.dof] * leant(limited);
    }
  }

  // Stores the pull of a frame's first step: force (dofs) is Jᵀλ, change (dofs) that step.
  void learn(std::span<const S> force, std::span<const S> change) {
    for (Limited& limited : limited_) {
      limited.pull = force[limited.dof] * free_[limited.dof];
      if (limited.leg) limited.pull = limited.pull - limited.slope * change[limited.slide];
    }
  }

  // Adds to q the lean that goes with a change of lengths (dofs, m).
  void follow_length(std::span<const S> change, std::span<S> q) const {
    for (const Limited& limited : limited_) {
      if (limited.leg) q[limited.dof] = q[limited.dof] + leant(limited) * change[limited.slide];
    }
  }

  // Clamps dofs that still passed a limit, and locks them for the rest of the frame.
  void hold(std::span<S> q, std::span<S> inverse) const {
    for (const Limited& limited : limited_) {
      const ReducedDof& dof = body_->dofs[limited.dof];
      const S by = moved_by(limited, q);
      S& angle = q[limited.dof];
      const S held = clamp(angle, S(dof.lower) + by, S(dof.upper) + by);
      const auto passed = (held < angle) | (held > angle);
      inverse[limited.dof] = select(passed, S(0), inverse[limited.dof]);
      angle = held;
    }
  }

 private:
  struct Limited {
    std::size_t dof = 0;
    // for a lean, with the ankle's limits
    std::size_t slide = 0;
    std::optional<BasicHingedLimb<S>> leg{};
    S pull{};    // the sign gives the limit it moves towards
    S share{1};  // present share of its weight
    S slope{};   // rad/m, present derivative of the shank's angle by the length
  };

  static bool contains(std::span<const int> chain, std::size_t dof) {
    for (const int d : chain) {
      if (index(d) == dof) return true;
    }
    return false;
  }

  // Additional lean per change of length (rad/m).
  [[nodiscard]] static S leant(const Limited& limited) {
    return (S(1) - limited.share) * limited.slope;
  }

  // Offset (rad) of the limits of a dof.
  [[nodiscard]] static S moved_by(const Limited& limited, std::span<const S> q) {
    return limited.leg ? limited.leg->direction_of_length(q[limited.slide]) : S(0);
  }

  const ReducedBody* body_;
  std::vector<Limited> limited_;
  std::vector<S> free_;  // (dofs) inverse weights far from limits
};

}  // namespace shigusa
