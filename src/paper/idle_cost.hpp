// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "criteria/motion_frame.hpp"
#include "kinematics/penetration.hpp"
#include "paper/layered_problem.hpp"

namespace shigusa {

// Weight of the cost P = min(1, depth / kCollisionFull) of an idle arm inside the body.
inline constexpr double kIdleCollisionWeight = 2.0;

// Cost of idle limbs, in addition to the whole body's criteria, frame by frame: the torques of dofs
// with a final angle, by their layers' criteria (as the criterion Torque, but for these dofs
// alone), and the depth of their arms in the body.
template <class S>
class IdleCost {
 public:
  // The setup outlives the object.
  explicit IdleCost(const LayeredSetup& setup) : body_(&setup.body()) {
    for (const auto& loads : setup.idle_loads) {
      const double count = static_cast<double>(loads.dofs.size()) * (setup.upper.reach->steps + 1);
      groups_.push_back({&loads, S(0), static_cast<T>(1.0 / count)});
    }
    for (const auto& arm : setup.idle_arms) arms_.push_back({&arm, S(0), S(0)});
  }

  void reset() {
    first_ = true;
    for (Group& group : groups_) group.squares = S(0);
    for (Arm& arm : arms_) arm.deepest = S(0);
  }

  void add(const PlacedFrame<S>& frame) {
    for (Group& group : groups_) {
      for (const int d : group.loads->dofs) {
        const Dof& joint = body_->dof(d);
        const S tau = frame.torques[index(d)];
        const S load =
            max(tau * S(1.0 / joint.torque_positive), -tau * S(1.0 / joint.torque_negative));
        group.squares = group.squares + load * load;
      }
    }
    for (Arm& arm : arms_) {
      const S depth = deepest_pair(arm, frame.kinematics);
      if (first_) arm.at_start = depth;
      arm.deepest = max(arm.deepest, depth - arm.at_start);
    }
    first_ = false;
  }

  [[nodiscard]] S cost() const {
    S cost(0);
    for (const Group& group : groups_) {
      const S share = sqrt(group.squares * S(group.per_count)) * S(1.0 / group.loads->share);
      cost = cost + min(S(1), share) * S(group.loads->weight);
    }
    S depth(0);
    for (const Arm& arm : arms_) depth = max(depth, arm.deepest);
    return cost + min(S(1), depth * S(1.0 / kCollisionFull)) * S(kIdleCollisionWeight);
  }

 private:
  using T = Element<S>;
  struct Group {
    const LayeredSetup::IdleLoads* loads = nullptr;
    S squares{};
    T per_count{};
  };
  struct Arm {
    const LayeredSetup::IdleArm* pairs = nullptr;
    S at_start{};  // m
    S deepest{};   // m
  };

  // Depth of the arm in the body (m), 0 if it is outside.
  S deepest_pair(const Arm& arm, const Kinematics<S>& kinematics) const {
    S most(0);
    for (const CapsulePair& pair : arm.pairs->pairs) {
      const Capsule& limb = body_->capsules()[index(pair.limb)];
      const Capsule& part = body_->capsules()[index(pair.part)];
      most = max(most, depth_of(placed_capsule<S>(limb, kinematics), limb,
                                placed_capsule<S>(part, kinematics), part));
    }
    return most;
  }

  const BodyModel* body_;
  bool first_ = true;
  std::vector<Group> groups_;
  std::vector<Arm> arms_;
};

}  // namespace shigusa
