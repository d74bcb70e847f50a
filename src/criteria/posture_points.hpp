// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/body_model.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

// A point that moves with a link.
struct LinkPoint {
  int link = kBaseLink;
  Vec3d at{};  // m, link frame

  template <class S>
  [[nodiscard]] Vec3<S> in(const Kinematics<S>& placed) const {
    return placed.point(link, at);
  }
};

// Where a body's posture is read off: both hips and both shoulders.
struct PosturePoints {
  std::array<LinkPoint, 2> hips;
  std::array<LinkPoint, 2> shoulders;
  Vec3d standing{};    // m, world: the middle of the feet's ankles in the start posture
  bool found = false;  // the body has all of them

  template <class S>
  [[nodiscard]] static Vec3<S> middle(const std::array<LinkPoint, 2>& pair,
                                      const Kinematics<S>& placed) {
    return (pair[0].in(placed) + pair[1].in(placed)) * S(0.5);
  }
};
// Finds them by the names of the body's nodes.
[[nodiscard]] PosturePoints posture_points(const BodyModel& body);

// One hand that has a goal, or, where no goals are known, any.
struct GoalHand {
  LinkPoint hand;
  LinkPoint shoulder;
  double arm = 0.0;  // m, from the shoulder to the hand with the arm stretched out
};
[[nodiscard]] std::vector<GoalHand> goal_hands(const BodyModel& body,
                                               const std::vector<int>& effectors);

}  // namespace shigusa
