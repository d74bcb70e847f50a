// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "body/coupled_limits.hpp"
#include "core/index.hpp"

namespace shigusa {

// A joint that moves towards a limit gives way to the others from this far before it (rad) …
inline constexpr double kLimitMargin = radians(8.0);
// … or from as far as it would go in this many steps.
inline constexpr double kLimitSteps = 5.0;
// A joint that leaves a limit gets its weight back by this share of it in a step.
inline constexpr double kLimitRise = 0.2;

// Joint limits inside the IK, as an active set that changes smoothly. Towards a limit a freedom's
// inverse weight, and what it is drawn by, fall to 0 over the last kLimitMargin, so that it comes
// to rest there while others take over, over more where it is fast; away from it, the freedom gets
// its own weight back within a few steps. In which direction it wants to go, and how fast, is taken
// from the step before. A step that would pass a limit in spite of that is held back there, and the
// rest is left for corrections to make up for with the other freedoms.
//
// A freedom that gives little (Dof::give) has that share of its inverse weight. As the ankle of a
// standing foot runs out of dorsiflexion the toes take over its inverse weight, and what it was
// drawn by: so heels lift where people's do. Toes of a weight above 1 take over that much less.
//
// After T. Chan and R. Dubey, IEEE Trans. Robotics and Automation 11 (1995) 286-292, where weights
// grow without bound towards a limit; here they do so at the limit itself, not before.
template <class S>
class LimitGuard {
 public:
  explicit LimitGuard(const BodyModel& body)
      : coupled_(body),
        wanted_(body.dofs().size()),
        share_(wanted_),
        most_(wanted_.size(), S(1)),
        given_(most_),
        softened_(wanted_),
        allowed_(wanted_) {
    for (std::size_t d = 0; d < wanted_.size(); ++d) {
      const Dof& dof = body.dofs()[d];
      // a start posture outside its range may stay where it is
      limits_.push_back({static_cast<T>(min(dof.lower, body.start()[d])),
                         static_cast<T>(max(dof.upper, body.start()[d]))});
      if (dof.give < 1.0) stiff_.push_back({d, static_cast<T>(dof.give)});
    }
    for (const Foot& foot : body.feet()) {
      if (!foot.heel) continue;
      heels_.push_back({index(foot.heel->toes), index(foot.heel->ankle), S(0)});
    }
    for (const Limit& limit : limits_) upper_.push_back(S(limit.upper));
    for (const std::size_t d : coupled_.coupled()) limits_[d].coupled = true;
  }

  // Before a motion's first step.
  void reset() {
    for (S& wanted : wanted_) wanted = S(0);
    for (S& most : most_) most = S(1);
    for (S& given : given_) given = S(1);
  }

  // From now on, freedoms that give little (Dof::give) give as the others do.
  void loosen() { stiff_.clear(); }

  // The inverse weights (dofs) to step with from the angles (dofs, rad).
  [[nodiscard]] std::span<const S> soften(std::span<const S> inverse_weights,
                                          std::span<const S> angles) {
    find_upper(angles);
    for (std::size_t d = 0; d < limits_.size(); ++d) {
      const S room =
          select(wanted_[d] > S(0), upper_[d] - angles[d], angles[d] - S(limits_[d].lower));
      const S margin = max(S(kLimitMargin), abs(wanted_[d]) * S(kLimitSteps));
      const S left = clamp(room / margin, S(0), S(1));
      // level where it begins: a joint that slowed down at once would jolt the body
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

  // The part of a reference (dofs, rad) that leads no freedom into its limit; after soften.
  [[nodiscard]] std::span<const S> allowed(std::span<const S> reference) {
    for (std::size_t d = 0; d < limits_.size(); ++d) allowed_[d] = reference[d] * given_[d];
    for (const HeldHeel& heel : heels_) {
      allowed_[heel.toes] = allowed_[heel.toes] + taken_of(heel, reference) * share_[heel.toes];
    }
    return allowed_;
  }

  // Keeps what each freedom would have done by its own weight: `pull` (dofs) is Jᵀ y, see
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

  // Holds the angles (dofs, rad) within the limits.
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
    bool coupled = false;  // upper grows with another angle
  };
  struct Stiff {
    std::size_t dof;
    T give;
  };
  struct HeldHeel {
    std::size_t toes;
    std::size_t ankle;
    S taken;  // 0..1, of what the ankle would do
  };

  // what the toes are drawn by in the ankle's place
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
  std::vector<S> upper_;     // (dofs) rad, with what the couplings add now
  std::vector<S> wanted_;    // (dofs) rad, the last step without limits
  std::vector<S> share_;     // (dofs) 0..1, how far a freedom may still follow its own weight
  std::vector<S> most_;      // (dofs) what that may be in this step …
  std::vector<S> given_;     // (dofs) … and is, having left a limit
  std::vector<S> softened_;  // (dofs) inverse weights
  std::vector<S> allowed_;   // (dofs) rad, of the reference
};

}  // namespace shigusa
