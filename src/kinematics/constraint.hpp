// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/forward_kinematics.hpp"
#include "motion/effector_turn.hpp"

namespace shigusa {

// The world as the carrier of a fixed place.
inline constexpr int kWorldCarrier = -2;

// The place of one point of the body, in the world or on a link that carries it, and perhaps the
// orientation of the point's link: a goal, a planted foot, or a hand that rests on a thigh.
template <class S>
struct Constraint {
  int link = 0;
  Vec3<Element<S>> point{};         // m, in the link's frame
  int carrier = kWorldCarrier;      // link, or kWorldCarrier
  Vec3<S> place{};                  // m, in the carrier's frame: target position of the point
  bool exact = false;               // true for contacts; a goal is damped where it cannot be met
  bool counts = true;               // false for a point led on a way that no task asks for
  Turning turning = Turning::free;  // part of the link's orientation that is prescribed
  Mat3<S> orientation{};            // target R_WL of the link, for Turning::whole
  Vec3<Element<S>> axis{};          // for Turning::axis: unit vector in the link's frame
  Vec3<S> direction{};              // target direction of the axis, unit vector in the world
  S active = S(1);                  // 1, or 0 in lanes whose point is free
  // Shares of the duration between which the point is to be at its place; it is led there before.
  double from = 0.0;
  double to = 1.0;
  double turn_counts = 1.0;  // share of a goal's turn error that counts before the end
  S lag{};                   // m, the goal's previous error: raises its damping
  // Known shortfall of a step, as joints move on arcs: added to the remaining error.
  Vec3<S> lead{};       // m
  Vec3<S> tilt_lead{};  // rad; used if turns() is true

  [[nodiscard]] bool turns() const { return turning != Turning::free; }
  [[nodiscard]] bool holds_at(double time) const { return from <= time && time <= to; }
  // Number of rows in the IK.
  [[nodiscard]] int rows() const { return turns() ? 6 : 3; }
};

// The same constraint for lanes, without lag and leads.
template <class S>
[[nodiscard]] Constraint<S> in_lanes(const Constraint<double>& constraint) {
  return {.link = constraint.link,
          .point = to_scalar<Element<S>>(constraint.point),
          .carrier = constraint.carrier,
          .place = to_scalar<S>(constraint.place),
          .exact = constraint.exact,
          .counts = constraint.counts,
          .turning = constraint.turning,
          .orientation = to_scalar<S>(constraint.orientation),
          .axis = to_scalar<Element<S>>(constraint.axis),
          .direction = to_scalar<S>(constraint.direction),
          .from = constraint.from,
          .to = constraint.to,
          .turn_counts = constraint.turn_counts};
}

// Position of a constraint's place (m, world).
template <class S>
[[nodiscard]] Vec3<S> place_in_world(const Kinematics<S>& kinematics,
                                     const Constraint<S>& constraint) {
  if (constraint.carrier == kWorldCarrier) return constraint.place;
  return kinematics.link_origin(constraint.carrier) +
         kinematics.link_rotation(constraint.carrier) * constraint.place;
}

// Error of the point (m, world); 0 if it is free.
template <class S>
[[nodiscard]] Vec3<S> position_error(const Kinematics<S>& kinematics,
                                     const Constraint<S>& constraint) {
  const Vec3<S> at = kinematics.point(constraint.link, constraint.point);
  return (place_in_world(kinematics, constraint) - at) * constraint.active;
}

// Rotation of a contact's link back to its orientation (rad for small ones, world).
template <class S>
[[nodiscard]] Vec3<S> tilt_error(const Kinematics<S>& kinematics, const Constraint<S>& contact) {
  return rotation_sine(kinematics.link_rotation(contact.link), contact.orientation);
}

// Angle of a contact's link from its orientation (rad for small turns, see rotation_chord).
template <class S>
[[nodiscard]] S tilt(const Kinematics<S>& kinematics, const Constraint<S>& contact) {
  return rotation_chord(kinematics.link_rotation(contact.link), contact.orientation);
}

// Rotation of the link to the constraint's orientation (rotation vector, rad, world); for contacts
// as tilt_error.
template <class S>
[[nodiscard]] Vec3<S> turn_error(const Kinematics<S>& kinematics, const Constraint<S>& constraint) {
  const Mat3<S>& now = kinematics.link_rotation(constraint.link);
  if (constraint.turning == Turning::axis) {
    return turn_between(now * to_scalar<S>(constraint.axis), constraint.direction);
  }
  if (constraint.exact) return tilt_error(kinematics, constraint);
  return rotation_vector(constraint.orientation * transpose(now));
}

}  // namespace shigusa
