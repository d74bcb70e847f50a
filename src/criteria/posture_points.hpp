// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/body.hpp>
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

// A standing person's hips, shoulders and centre of mass are so far ahead of the ankles, in
// statures (those of the built-in bodies), and a hanging hand so far above them.
inline constexpr double kStandsAhead = 0.017;
inline constexpr double kHandHangs = 0.40;

// Where a body's posture is read off, both hips and both shoulders, and where it is at home:
// upright over its feet, whatever its start; of a body without knees to straighten, as one that
// sits, its start.
struct PosturePoints {
  std::array<LinkPoint, 2> hips;
  std::array<LinkPoint, 2> shoulders;
  Vec3d ankles{};                         // m, world: the middle of both in the start posture
  std::array<Vec3d, 2> home_shoulders{};  // m, world
  Vec3d home_mass{};                      // m, world: the centre of mass; its height is not set
  double hand_hangs = 0.0;                // m, world: the height of a hand that hangs
  bool found = false;                     // the body has all of them

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
  Vec3d home{};      // m, world: of the shoulder, see PosturePoints
  double arm = 0.0;  // m, from the shoulder to the hand with the arm stretched out
};
[[nodiscard]] std::vector<GoalHand> goal_hands(const BodyModel& body,
                                               const std::vector<int>& effectors);

}  // namespace shigusa
