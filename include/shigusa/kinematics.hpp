// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace shigusa {

/// Jacobian of a point of a link, six rows by columns: that of freedom d is linear[d] above
/// angular[d]. Both are 0 where the freedom does not move the link.
struct PointJacobian {
  std::vector<Vec3d> linear;   ///< (dofs) m/rad, world: velocity of the point per angular speed
  std::vector<Vec3d> angular;  ///< (dofs) rad/rad, world: angular velocity of the link per the same
};

/// A body at given angles: where its parts are, how they move with the angles, and the torques that
/// hold it. Immutable; copies share all of it. The body must outlive it.
///
///     const BodyModel body = human_body();
///     const Posture posture(body, body.start());
///     const Effector& hand = body.effectors()[0];
///     const Vec3d at = posture.place(hand).translation;
///     const PointJacobian moves = posture.jacobian(hand.link, hand.point);
class Posture {
 public:
  /// `angles`: (dofs) rad, which may lie beyond the limits. PreconditionError where their number is
  /// another, or one is not finite or beyond 10⁶.
  Posture(const BodyModel& body, std::span<const double> angles);
  Posture(const BodyModel&&, std::span<const double>) = delete;  ///< its body would be gone

  [[nodiscard]] const BodyModel& body() const;           ///< as it was given
  [[nodiscard]] std::span<const double> angles() const;  ///< (dofs) rad, as they were given
  /// X_WL, the place of a link's frame in the world: kBaseLink or the number of a freedom, else
  /// PreconditionError.
  [[nodiscard]] Transformd place(int link) const;
  /// X_WN of a node of the body: its origin, with the axes of its link.
  [[nodiscard]] Transformd place(const BodyNode& node) const;
  /// X_WE of an effector of the body: its point, with the axes of its link (see GoalAxis).
  [[nodiscard]] Transformd place(const Effector& effector) const;
  /// Place of the effector that BodyModel::find_effector finds; fails where there is none.
  [[nodiscard]] Result<Transformd> effector_place(std::string_view name) const;
  /// Place of the node of that name: "right_hand" is at the wrist, where the effector of that name
  /// is the grip. Fails where the body has none.
  [[nodiscard]] Result<Transformd> node_place(std::string_view name) const;
  /// Jacobian of a point (m, in the frame of its link); PreconditionError as of place.
  [[nodiscard]] PointJacobian jacobian(int link, const Vec3d& point) const;
  /// Centre of mass of the whole body (m, world).
  [[nodiscard]] Vec3d centre_of_mass() const;
  /// (dofs) N·m, positive towards larger angles: torques by which the joints hold the body still
  /// under gravity, as in a motion at rest. The floor holds the base's foot however the body leans;
  /// of two feet that stand, each bears its share by the lever rule along the line between them.
  /// They are computed at each call.
  [[nodiscard]] std::vector<double> holding_torques() const;

 private:
  struct Placed;
  std::shared_ptr<const Placed> placed_;
};

}  // namespace shigusa
