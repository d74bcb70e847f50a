// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <span>
#include <vector>

#include "body/body_constants.hpp"
#include "core/index.hpp"

namespace shigusa {

// World placement of every link of a body. One entry per dof, in the body's order.
template <class S>
struct Kinematics {
  // (dofs) R_WL of the link that the dof moves; set only for the last dof of a joint
  std::vector<Mat3<S>> rotation;
  std::vector<Vec3<S>> origin;  // (dofs) m, joint centre in the world
  std::vector<Vec3<S>> axis;    // (dofs) unit vector, world: positive angles turn about it
  std::vector<SinCos<S>> turn;  // (dofs) sine and cosine of the angle about the axis
  Mat3<S> base_rotation{};      // of the base foot
  Vec3<S> base_origin{};        // m

  explicit Kinematics(const BodyModel& body)
      : rotation(body.dofs().size()),
        origin(body.dofs().size()),
        axis(body.dofs().size()),
        turn(body.dofs().size()) {}

  [[nodiscard]] const Mat3<S>& link_rotation(int link) const {
    return link == kBaseLink ? base_rotation : rotation[index(link)];
  }
  [[nodiscard]] const Vec3<S>& link_origin(int link) const {
    return link == kBaseLink ? base_origin : origin[index(link)];
  }
  // World position (m) of a point fixed in a link.
  template <class T = double>
  [[nodiscard]] Vec3<S> point(int link, const Vec3<T>& local) const {
    return link_origin(link) + link_rotation(link) * to_scalar<S>(local);
  }
};

// Rotation times a vector; `upright`: the vector has only a y component.
template <class S, class T>
[[nodiscard, gnu::always_inline]] inline Vec3<S> times_place(const Mat3<S>& rotation,
                                                             const Vec3<T>& place, bool upright) {
  if (upright) return rotation.cy * S(place.y);
  return rotation.cx * S(place.x) + rotation.cy * S(place.y) + rotation.cz * S(place.z);
}

// Places the link of a joint whose single axis is not a coordinate axis: R_WL = R_WP T R(q) Tᵀ. Its
// turn must be known.
template <class S>
void turn_slanting(const BodyConstants<Element<S>>& constants, std::size_t joint,
                   const Mat3<S>& carrier, Kinematics<S>& kinematics) {
  const std::size_t d = index(constants.joints[joint].link);
  const auto& dof = constants.dofs[d];
  const Mat3<S> turn = to_scalar<S>(constants.turns[joint]);
  const Mat3<S> before = carrier * turn;
  const Vec3<S> axis = dof.axis == Axis::x   ? before.cx
                       : dof.axis == Axis::y ? before.cy
                                             : before.cz;
  kinematics.origin[d] = kinematics.link_origin(dof.parent) + carrier * to_scalar<S>(dof.offset);
  kinematics.axis[d] = dof.negative ? -axis : axis;
  kinematics.rotation[d] = rotated(before, dof.axis, kinematics.turn[d]) * transpose(turn);
}

// Places the links of a joint whose axes are coordinate axes. The turns must be known.
template <class S>
[[gnu::always_inline]] inline void turn_joint(
    const BodyConstants<Element<S>>& constants,
    const typename BodyConstants<Element<S>>::Joint& joint, const Mat3<S>& carrier,
    Kinematics<S>& kinematics) {
  const std::size_t first = index(joint.first);
  const std::size_t link = index(joint.link);
  // separate columns stay in registers
  Vec3<S> x = carrier.cx;
  Vec3<S> y = carrier.cy;
  Vec3<S> z = carrier.cz;
  const Vec3<S> centre = kinematics.link_origin(constants.dofs[first].parent) +
                         times_place(carrier, constants.dofs[first].offset, joint.hangs);
  for (std::size_t d = first; d <= link; ++d) {
    const auto& dof = constants.dofs[d];
    const SinCos<S>& turn = kinematics.turn[d];
    Vec3<S>& axis = kinematics.axis[d];
    kinematics.origin[d] = {centre.x, centre.y, centre.z};
    switch (dof.axis) {
      case Axis::x:
        axis = dof.negative ? -x : x;
        turn_columns(y, z, turn);
        break;
      case Axis::y:
        axis = dof.negative ? -y : y;
        turn_columns(z, x, turn);
        break;
      default:
        axis = dof.negative ? -z : z;
        turn_columns(x, y, turn);
    }
  }
  kinematics.rotation[link] = {x, y, z};
}

// Places all links for the joint angles q (dofs, rad).
template <class S>
void forward_kinematics(const BodyModel& body, std::span<const S> q, Kinematics<S>& kinematics) {
  const BodyConstants<Element<S>>& constants = body.constants<Element<S>>();
  kinematics.base_rotation = to_scalar<S>(constants.base_rotation);
  kinematics.base_origin = to_scalar<S>(constants.base_origin);
  // computed first, as they are independent of one another
  for (std::size_t i = 0; i < constants.dofs.size(); ++i) {
    kinematics.turn[i] = sin_cos(constants.dofs[i].negative ? -q[i] : q[i]);
  }
  for (std::size_t j = 0; j < constants.joints.size(); ++j) {
    const auto& joint = constants.joints[j];
    const Mat3<S>& carrier = kinematics.link_rotation(constants.dofs[index(joint.first)].parent);
    if (joint.slants) {
      turn_slanting(constants, j, carrier, kinematics);
    } else {
      turn_joint(constants, joint, carrier, kinematics);
    }
  }
}

// Placement of the body in a state.
[[nodiscard]] Kinematics<double> placed(const BodyModel& body, const State& state);
// Placement of the body in its start posture.
[[nodiscard]] Kinematics<double> home_kinematics(const PosedBody& body);

// Velocity (m/rad, world) of the world point `at`, carried by the dof's link, per unit of the
// dof's speed: column of the position Jacobian.
template <class S>
[[nodiscard]] Vec3<S> position_column(const Kinematics<S>& kinematics, int dof, const Vec3<S>& at) {
  const std::size_t i = index(dof);
  return cross(kinematics.axis[i], at - kinematics.origin[i]);
}

}  // namespace shigusa
