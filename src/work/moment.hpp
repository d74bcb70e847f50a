// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/action.hpp>
#include <shigusa/body.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

// A hand on a thing.
struct Grip {
  int hand = 0;           // index of the effector, see BodyModel::effector
  int link = 0;           // of the hand
  std::size_t thing = 0;  // index of the thing
  Transformd in_hand{};   // X_LT, pose of the thing in the frame of the hand's link
};

// A moment of a piece of work, at rest: the body's angles, the things' poses, the hands on them.
struct Moment {
  std::vector<double> angles{};      // (dofs) rad
  std::vector<Transformd> things{};  // (things) X_WT
  std::vector<Grip> grips{};         // hands of a thing in the order in which they took it

  // The grips on a thing.
  [[nodiscard]] std::vector<Grip> on(std::size_t thing) const;
  // The thing in a hand.
  [[nodiscard]] std::optional<std::size_t> in(int hand) const;
};

// Pose of a thing at the start.
[[nodiscard]] Transformd start_pose(const Thing& thing);
// Pose with a turn (degrees) about the vertical.
[[nodiscard]] Transformd upright_pose(const Vec3d& position, double turn_deg);

// Pose of a thing in the hands of a placed body, between those by each grip.
[[nodiscard]] Transformd held_pose(const Kinematics<double>& placed, std::span<const Grip> grips);

// The load of a thing in a hand, one of `hands` that share it; the first one's also collides.
[[nodiscard]] HeldLoad load_of(const BodyModel& body, const Thing& thing, const Grip& grip,
                               std::size_t hands, bool first);

// A thing as obstacles, one for each of its parts.
[[nodiscard]] std::vector<Obstacle> obstacles_of(const Thing& thing, const Transformd& pose);

// The state of the body in a moment, with the things in its hands as loads.
[[nodiscard]] State state_of(const BodyModel& body, std::span<const Thing> things,
                             const Moment& moment);

}  // namespace shigusa
