// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace shigusa {

/// Jacobian of a point of a link, (6 × dofs), by columns: column d is linear[d] above angular[d].
/// Both are 0 for a degree of freedom that does not move the link.
struct PointJacobian {
  std::vector<Vec3d> linear;   ///< (dofs) m/rad, world: velocity of the point per angular speed
  std::vector<Vec3d> angular;  ///< (dofs) rad/rad, world: angular velocity of the link per the same
};

/// A body at given joint angles: poses of its links, Jacobians, centre of mass, and the torques
/// that hold it still. Immutable; copies share their data. The body must outlive it.
class Posture {
 public:
  /// `angles`: (dofs) rad; limits are not enforced. PreconditionError if their number differs from
  /// dof_count(), or one is not finite or exceeds 10⁶.
  Posture(const BodyModel& body, std::span<const double> angles);
  Posture(const BodyModel&&, std::span<const double>) = delete;  ///< a temporary body dies

  [[nodiscard]] const BodyModel& body() const;           ///< the body passed in
  [[nodiscard]] std::span<const double> angles() const;  ///< (dofs) rad
  /// X_WL, pose of a link's frame in the world. `link`: kBaseLink or 0..dof_count()-1, else
  /// PreconditionError.
  [[nodiscard]] Transformd place(int link) const;
  /// X_WN, pose of a node of the body: its origin, with the axes of its link.
  [[nodiscard]] Transformd place(const BodyNode& node) const;
  /// X_WE, pose of an effector of the body: its point, with the axes of its link (see GoalAxis).
  [[nodiscard]] Transformd place(const Effector& effector) const;
  /// Pose of the effector that BodyModel::find_effector finds; ErrorCode::not_found if none.
  [[nodiscard]] Result<Transformd> effector_place(std::string_view name) const;
  /// Pose of the node of that name; ErrorCode::not_found if none. The node "right_hand" is the
  /// wrist, the effector "right_hand" the grip.
  [[nodiscard]] Result<Transformd> node_place(std::string_view name) const;
  /// Jacobian of a point (m, link frame). PreconditionError for an unknown link.
  [[nodiscard]] PointJacobian jacobian(int link, const Vec3d& point) const;
  /// Centre of mass of the whole body (m, world).
  [[nodiscard]] Vec3d centre_of_mass() const;
  /// (dofs) N·m, positive towards larger angles: joint torques that hold the body still under
  /// gravity. The floor supports the base foot wherever the centre of mass is; two standing feet
  /// share the load by the lever rule along the line between them. Computed at each call.
  [[nodiscard]] std::vector<double> holding_torques() const;

 private:
  struct Placed;
  std::shared_ptr<const Placed> placed_;
};

}  // namespace shigusa
