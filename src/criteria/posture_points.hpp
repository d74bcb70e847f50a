// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <vector>

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

// A point fixed to a link.
struct LinkPoint {
  int link = kBaseLink;
  Vec3d at{};  // m, link frame

  template <class S>
  [[nodiscard]] Vec3<S> in(const Kinematics<S>& placed) const {
    return placed.point(link, at);
  }
};

// Distance of a standing person's hips, shoulders and centre of mass ahead of the ankles, and
// height of a hanging hand above them, in statures (those of the built-in bodies).
inline constexpr double kStandsAhead = 0.017;
inline constexpr double kHandHangs = 0.40;

// Points that describe a body's posture, both hips and both shoulders, and their home positions:
// upright over the feet, whatever the start posture; for a body without knees, such as a seated
// one, the start posture.
struct PosturePoints {
  std::array<LinkPoint, 2> hips;
  std::array<LinkPoint, 2> shoulders;
  Vec3d ankles{};                         // m, world: the midpoint of both in the start posture
  std::array<Vec3d, 2> home_shoulders{};  // m, world
  Vec3d home_mass{};                      // m, world: the centre of mass; its height is not set
  double hand_hangs = 0.0;                // m, world: the height of a hanging hand
  double leg = 0.0;                       // m, from hip to ankle of a straight leg, mean of both
  bool found = false;                     // whether the body has all points

  // The line (m, world) from the middle of the hips to that of the shoulders.
  template <class S>
  [[nodiscard]] Vec3<S> trunk(const Kinematics<S>& placed) const {
    return middle(shoulders, placed) - middle(hips, placed);
  }
  template <class S>
  [[nodiscard]] static Vec3<S> middle(const std::array<LinkPoint, 2>& pair,
                                      const Kinematics<S>& placed) {
    return (pair[0].in(placed) + pair[1].in(placed)) * S(0.5);
  }
};
// Finds the points by the names of the body's nodes.
[[nodiscard]] PosturePoints posture_points(const BodyModel& body, const State& state);

// One hand that has a goal; any hand if no goals are known.
struct GoalHand {
  LinkPoint hand;
  LinkPoint shoulder;
  Vec3d home{};      // m, world: home position of the shoulder, see PosturePoints
  double arm = 0.0;  // m, from the shoulder to the hand of a straight arm
};
[[nodiscard]] std::vector<GoalHand> goal_hands(const BodyModel& body,
                                               const CriteriaContext& context);

}  // namespace shigusa
