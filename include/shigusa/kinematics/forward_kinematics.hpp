// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body/body_model.hpp>
#include <span>
#include <vector>

namespace shigusa {

// World placement of every link of a body. One entry per dof, in the body's order.
template <class S>
struct Kinematics {
  std::vector<Mat3<S>> rotation;  // (dofs) R_WL of the link that the dof moves
  std::vector<Vec3<S>> origin;    // (dofs) m, joint centre in the world
  std::vector<Vec3<S>> axis;      // (dofs) unit vector, world: positive angles turn about it
  std::vector<SinCos<S>> turn;    // (dofs) sine and cosine of the angle about the axis
  Mat3<S> base_rotation{};        // of the standing foot
  Vec3<S> base_origin{};          // m

  explicit Kinematics(const BodyModel& body)
      : rotation(body.dofs().size()),
        origin(body.dofs().size()),
        axis(body.dofs().size()),
        turn(body.dofs().size()) {}

  [[nodiscard]] const Mat3<S>& link_rotation(int link) const {
    return link == kBaseLink ? base_rotation : rotation[static_cast<std::size_t>(link)];
  }
  [[nodiscard]] const Vec3<S>& link_origin(int link) const {
    return link == kBaseLink ? base_origin : origin[static_cast<std::size_t>(link)];
  }
  // World position (m) of a point that is fixed in a link.
  template <class T = double>
  [[nodiscard]] Vec3<S> point(int link, const Vec3<T>& local) const {
    return link_origin(link) + link_rotation(link) * to_scalar<S>(local);
  }
};

// Places all links for the joint angles q (dofs, rad).
template <class S>
void forward_kinematics(const BodyModel& body, std::span<const S> q, Kinematics<S>& kinematics) {
  const BodyConstants<Element<S>>& constants = body.constants<Element<S>>();
  kinematics.base_rotation = to_scalar<S>(constants.base_rotation);
  kinematics.base_origin = to_scalar<S>(constants.base_origin);
  // first, as none of these waits for another
  for (std::size_t i = 0; i < constants.dofs.size(); ++i) {
    kinematics.turn[i] = sin_cos(constants.dofs[i].negative ? -q[i] : q[i]);
  }
  for (std::size_t i = 0; i < constants.dofs.size(); ++i) {
    const auto& dof = constants.dofs[i];
    const Mat3<S>& parent = kinematics.link_rotation(dof.parent);
    const Vec3<S>& centre = kinematics.link_origin(dof.parent);
    const Vec3<S>& axis = parent.column(static_cast<int>(dof.axis));
    kinematics.axis[i] = dof.negative ? -axis : axis;
    kinematics.origin[i] = dof.at_parent ? centre : centre + parent * to_scalar<S>(dof.offset);
    kinematics.rotation[i] = rotated(parent, dof.axis, kinematics.turn[i]);
  }
}

// Velocity (m/rad, world) of the world point `at`, carried by the dof's link, per unit of the
// dof's speed: column of the position Jacobian.
template <class S>
[[nodiscard]] Vec3<S> position_column(const Kinematics<S>& kinematics, int dof, const Vec3<S>& at) {
  const auto i = static_cast<std::size_t>(dof);
  return cross(kinematics.axis[i], at - kinematics.origin[i]);
}

}  // namespace shigusa
