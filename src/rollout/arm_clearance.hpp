// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <shigusa/human.hpp>
#include <vector>

#include "core/index.hpp"
#include "kinematics/penetration.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Clearance (m) that a hanging arm keeps from trunk and legs.
inline constexpr double kArmKeepsOff = 0.01;
// Least rate (m/rad) at which abduction must move an arm away from a part to be used.
inline constexpr double kArmGoesAside = 0.05;

// The pairs of a hanging arm and the parts of the body that it comes near, with their depths at the
// start as the tolerated ones; negative where they are apart.
[[nodiscard]] std::vector<CapsulePair> clearance_pairs(const ReachProblem& problem,
                                                       const Effector& hand);

// The abduction that keeps an arm without a goal clear of the body. A pair that is nearer in the
// start posture may stay as near.
template <class S>
class ArmClearance {
 public:
  // `abduction`: that dof of the shoulder, or another that moves the arm off.
  ArmClearance(const ReachProblem& problem, const Effector& hand, int abduction)
      : abduction_(abduction) {
    for (const CapsulePair& pair : clearance_pairs(problem, hand)) {
      const Capsule& limb = problem.body->capsules()[index(pair.limb)];
      const Capsule& part = problem.body->capsules()[index(pair.part)];
      pairs_.push_back(
          {add(limb), add(part),
           static_cast<T>(limb.radius + part.radius - max(pair.allowed, -kArmKeepsOff)),
           static_cast<T>(taper_of(limb)), static_cast<T>(taper_of(part))});
    }
    placed_.resize(capsules_.size());
  }

  // Abduction (rad) needed in the placement `now`; if negative, the arm may be lowered by that
  // much.
  [[nodiscard]] S aside(const Kinematics<S>& now) {
    for (std::size_t c = 0; c < capsules_.size(); ++c) {
      place_capsule(capsules_[c].link, capsules_[c].from, capsules_[c].to, now, placed_[c]);
    }
    S most(-kFar);
    for (const Pair& pair : pairs_) {
      const PlacedCapsule<S>& limb = placed_[pair.limb];
      const PlacedCapsule<S>& part = placed_[pair.part];
      const NearestPlaces<S> nearest = nearest_places(limb, part);
      const S distance = sqrt(max(dot(nearest.apart, nearest.apart), S(kPoint)));
      const Vec3<S> at = limb.from + (limb.to - limb.from) * nearest.along_a;
      const S off = dot(nearest.apart, position_column(now, abduction_, at)) / distance;
      const S in = S(pair.radii) + nearest.along_a * S(pair.taper_limb) +
                   nearest.along_b * S(pair.taper_part) - distance;
      const auto helps = off > S(kArmGoesAside);
      most = max(most, select(helps, in / max(off, S(kArmGoesAside)), S(-kFar)));
    }
    return most;
  }

 private:
  using T = Element<S>;
  static constexpr double kFar = 1.0;      // rad, result without a pair in the way
  static constexpr double kPoint = 1e-12;  // m²
  struct Line {
    int link = 0;
    Vec3<T> from{};  // m, link frame
    Vec3<T> to{};
  };
  struct Pair {
    std::size_t limb = 0;  // in `capsules_`
    std::size_t part = 0;
    T radii{};  // m, sum at their first ends, less the depth allowed at the start
    T taper_limb{};
    T taper_part{};
  };

  std::size_t add(const Capsule& capsule) {
    const Line line{capsule.link, to_scalar<T>(capsule.from), to_scalar<T>(capsule.to)};
    const auto known = std::find_if(capsules_.begin(), capsules_.end(), [&](const Line& other) {
      return other.link == line.link && other.from == line.from && other.to == line.to;
    });
    if (known != capsules_.end()) return static_cast<std::size_t>(known - capsules_.begin());
    capsules_.push_back(line);
    return capsules_.size() - 1;
  }

  int abduction_;
  std::vector<Line> capsules_;
  std::vector<Pair> pairs_;
  std::vector<PlacedCapsule<S>> placed_;
};

}  // namespace shigusa
