// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "body/coupled_limits.hpp"
#include "core/index.hpp"

namespace shigusa {

// Distance (rad) to a limit from which a joint moving towards it yields to the others.
inline constexpr double kLimitMargin = radians(8.0);
// The same distance for a fast joint, in steps at its present velocity.
inline constexpr double kLimitSteps = 5.0;
// Share of its weight that a joint regains per step after leaving a limit.
inline constexpr double kLimitRise = 0.2;

// Joint limits inside the IK, as an active set that changes smoothly. Towards a limit a dof's
// inverse weight and its reference fall to 0 over the last kLimitMargin, or more if it is fast, so
// that it comes to rest there while others take over; away from it, the dof regains its own weight
// within a few steps. Direction and velocity are those of the step before. A step that would still
// pass a limit is stopped there, and corrections make up for the rest with the other dofs.
//
// The inverse weight of a stiff dof is multiplied by Dof::give. As the ankle of a standing foot
// runs out of dorsiflexion the toes take over its inverse weight and its reference, so that heels
// lift at the same moment as people's. Toes with a weight above 1 take over that much less.
//
// After T. Chan and R. Dubey, IEEE Trans. Robotics and Automation 11 (1995) 286-292, where weights
// grow without bound towards a limit; here they do so only at the limit itself.
template <class S>
class LimitGuard {
 public:
  LimitGuard(const BodyModel& body, const State& start)
      : coupled_(body),
        wanted_(body.dofs().size()),
        share_(wanted_),
        most_(wanted_.size(), S(1)),
        given_(most_),
        softened_(wanted_),
        allowed_(wanted_) {
    for (std::size_t d = 0; d < wanted_.size(); ++d) {
      const Dof& dof = body.dofs()[d];
      // a start posture out of range may stay as it is
      limits_.push_back({static_cast<T>(min(dof.lower, start.angles[d])),
                         static_cast<T>(max(dof.upper, start.angles[d]))});
      if (dof.give < 1.0) stiff_.push_back({d, static_cast<T>(dof.give)});
    }
    for (const Foot& foot : body.feet()) {
      if (!foot.heel) continue;
      heels_.push_back({index(foot.heel->toes), index(foot.heel->ankle), S(0)});
    }
    for (const Limit& limit : limits_) upper_.push_back(S(limit.upper));
    for (const std::size_t d : coupled_.coupled()) limits_[d].coupled = true;
  }

  // Resets the state before a motion's first step.
  void reset() {
    for (S& wanted : wanted_) wanted = S(0);
    for (S& most : most_) most = S(1);
    for (S& given : given_) given = S(1);
  }

  // Ignores Dof::give from now on.
  void loosen() { stiff_.clear(); }

  // The inverse weights (dofs) for a step from the angles (dofs, rad).
  [[nodiscard]] std::span<const S> soften(std::span<const S> inverse_weights,
                                          std::span<const S> angles) {
    find_upper(angles);
    for (std::size_t d = 0; d < limits_.size(); ++d) {
      const S room =
          select(wanted_[d] > S(0), upper_[d] - angles[d], angles[d] - S(limits_[d].lower));
      const S margin = max(S(kLimitMargin), abs(wanted_[d]) * S(kLimitSteps));
      const S left = clamp(room / margin, S(0), S(1));
      // starts with slope 0: a sudden deceleration would jolt the body
      share_[d] = left * (S(2) - left);
      given_[d] = min(share_[d], most_[d]);
      softened_[d] = inverse_weights[d] * given_[d];
    }
    for (const Stiff& s : stiff_) softened_[s.dof] = softened_[s.dof] * S(s.give);
    for (HeldHeel& heel : heels_) {
      const S over = select(wanted_[heel.ankle] > S(0), S(1) - share_[heel.ankle], S(0));
      heel.taken = over * min(inverse_weights[heel.toes], S(1));
      softened_[heel.toes] =
          softened_[heel.toes] + inverse_weights[heel.ankle] * heel.taken * share_[heel.toes];
    }
    return softened_;
  }

  // The reference (dofs, rad) without the part that leads into limits; after soften.
  [[nodiscard]] std::span<const S> allowed(std::span<const S> reference) {
    for (std::size_t d = 0; d < limits_.size(); ++d) allowed_[d] = reference[d] * given_[d];
    for (const HeldHeel& heel : heels_) {
      allowed_[heel.toes] = allowed_[heel.toes] + taken_of(heel, reference) * share_[heel.toes];
    }
    return allowed_;
  }

  // Stores the step that each dof would make by its own weight: `pull` (dofs) is Jᵀ y, see
  // IkWorkspace.
  void learn(std::span<const S> inverse_weights, std::span<const S> pull,
             std::span<const S> reference) {
    for (std::size_t d = 0; d < limits_.size(); ++d) {
      wanted_[d] = inverse_weights[d] * pull[d];
      most_[d] = given_[d] + S(kLimitRise);
      if (!reference.empty()) wanted_[d] = wanted_[d] + reference[d];
    }
    for (const Stiff& s : stiff_) {
      const S own = inverse_weights[s.dof] * pull[s.dof];
      wanted_[s.dof] = wanted_[s.dof] - own + own * S(s.give);
    }
    for (const HeldHeel& heel : heels_) {
      S& wanted = wanted_[heel.toes];
      wanted = wanted + inverse_weights[heel.ankle] * heel.taken * pull[heel.toes];
      if (!reference.empty()) wanted = wanted + taken_of(heel, reference);
    }
  }

  // Clamps the angles (dofs, rad) to the limits.
  void hold(std::span<S> angles) {
    for (std::size_t d = 0; d < limits_.size(); ++d) {
      if (!limits_[d].coupled) {
        angles[d] = clamp(angles[d], S(limits_[d].lower), S(limits_[d].upper));
      }
    }
    find_upper(angles);
    for (const std::size_t d : coupled_.coupled()) {
      angles[d] = clamp(angles[d], S(limits_[d].lower), upper_[d]);
    }
  }

 private:
  using T = Element<S>;
  struct Limit {
    T lower;
    T upper;
    bool coupled = false;  // upper limit depends on another angle
  };
  struct Stiff {
    std::size_t dof;
    T give;
  };
  struct HeldHeel {
    std::size_t toes;
    std::size_t ankle;
    S taken;  // 0..1, share of the ankle's step
  };

  // Reference of the ankle that the toes take over.
  static S taken_of(const HeldHeel& heel, std::span<const S> reference) {
    return max(reference[heel.ankle], S(0)) * heel.taken;
  }

  void find_upper(std::span<const S> angles) {
    coupled_.update(angles);
    for (const std::size_t d : coupled_.coupled()) {
      upper_[d] = S(limits_[d].upper) + coupled_.added()[d];
    }
  }

  std::vector<Limit> limits_;
  CoupledLimits<S> coupled_;
  std::vector<Stiff> stiff_;
  std::vector<HeldHeel> heels_;
  std::vector<S> upper_;     // (dofs) rad, with the present additions of the couplings
  std::vector<S> wanted_;    // (dofs) rad, the last step without limits
  std::vector<S> share_;     // (dofs) 0..1, share of its weight by the distance to the limit
  std::vector<S> most_;      // (dofs) upper bound of that share after leaving a limit
  std::vector<S> given_;     // (dofs) share applied in this step
  std::vector<S> softened_;  // (dofs) inverse weights
  std::vector<S> allowed_;   // (dofs) rad, the allowed reference
};

}  // namespace shigusa
