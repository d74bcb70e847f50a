// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/kinematics/forward_kinematics.hpp>
#include <span>
#include <vector>

namespace shigusa {

inline constexpr double kGravity = 9.80665;  // m/s², standard

// A force and its moment about a stated point, world axes.
template <class S>
struct Wrench {
  Vec3<S> force{};   // N
  Vec3<S> moment{};  // N·m
};

// Scratch of inverse_dynamics; make one per thread.
template <class S>
struct DynamicsWorkspace {
  // What is known of one rigid piece of the body (BodyConstants::Joint).
  struct Piece {
    Vec3<S> spin{};          // rad/s, world
    Vec3<S> spin_rate{};     // rad/s², world
    Vec3<S> acceleration{};  // m/s², of the joint's centre, less gravity
    Mat3<S> turning{};       // 1/s²: times a point's place seen from the centre, its acceleration
    Wrench<S> carried{};     // through the joint, moment about its centre
  };
  std::vector<Piece> pieces;
  // Σ mass · place of the pieces' centres of mass (kg·m, world), the base's included: a by-product
  Vec3<S> mass_moment{};

  explicit DynamicsWorkspace(const BodyModel& body)
      : pieces(body.constants<Element<S>>().joints.size()) {}
};

// Centre of mass of the whole body (m, world) at the placement that inverse_dynamics saw last.
template <class S>
[[nodiscard]] Vec3<S> centre_of_mass(const BodyModel& body, const DynamicsWorkspace<S>& work) {
  return work.mass_moment * S(Element<S>(1) / body.constants<Element<S>>().total_mass);
}

namespace dynamics_detail {

// [α]× + [ω]× [ω]×: the acceleration of a rigid piece's points, per place
template <class S>
[[nodiscard]] Mat3<S> turning(const Vec3<S>& spin, const Vec3<S>& rate) {
  const S xx = spin.x * spin.x;
  const S yy = spin.y * spin.y;
  const S zz = spin.z * spin.z;
  const S xy = spin.x * spin.y;
  const S xz = spin.x * spin.z;
  const S yz = spin.y * spin.z;
  return {{-(yy + zz), xy + rate.z, xz - rate.y},
          {xy - rate.z, -(xx + zz), yz + rate.x},
          {xz + rate.y, yz - rate.x, -(xx + yy)}};
}

// inertia times v, both in world axes
template <class S, class Joint>
[[nodiscard, gnu::always_inline]] inline Vec3<S> inertia_times(const Joint& joint,
                                                               const Mat3<S>& rotation,
                                                               const Vec3<S>& v) {
  const Vec3<S> local = transpose_times(rotation, v);
  if (joint.principal) {
    return rotation * Vec3<S>{local.x * S(joint.inertia.cx.x), local.y * S(joint.inertia.cy.y),
                              local.z * S(joint.inertia.cz.z)};
  }
  return rotation * (to_scalar<S>(joint.inertia) * local);
}

}  // namespace dynamics_detail

// Joint torques of a body on its fixed base by the recursive Newton-Euler algorithm: tau_i is what
// joint i must give (N·m, positive towards larger angles) for the speeds qd (rad/s) and
// accelerations qdd (rad/s²) at the placement `kinematics`, under gravity along -Y. Returns the
// wrench that the floor gives to the base, moment about the world's origin.
// Source: R. Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 5; in world coordinates.
template <class S>
Wrench<S> inverse_dynamics(const BodyModel& body, const Kinematics<S>& kinematics,
                           std::span<const S> qd, std::span<const S> qdd,
                           DynamicsWorkspace<S>& work, std::span<S> tau) {
  const BodyConstants<Element<S>>& constants = body.constants<Element<S>>();
  const std::size_t count = constants.joints.size();
  // accelerating upwards by g replaces the weight
  const Vec3<S> lift{S(0), S(kGravity), S(0)};
  const Vec3<S> base_com = kinematics.point(kBaseLink, constants.base_com);
  work.mass_moment = base_com * S(constants.base_mass);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& joint = constants.joints[i];
    auto& piece = work.pieces[i];
    const auto first = static_cast<std::size_t>(joint.first);
    const auto link = static_cast<std::size_t>(joint.link);
    piece.acceleration = lift;
    Vec3<S> spin{};
    Vec3<S> rate{};
    if (joint.parent >= 0) {
      const auto p = static_cast<std::size_t>(joint.parent);
      const auto parent_link = static_cast<std::size_t>(constants.joints[p].link);
      const auto& parent = work.pieces[p];
      const Vec3<S> arm = kinematics.origin[first] - kinematics.origin[parent_link];
      piece.acceleration = parent.acceleration + parent.turning * arm;
      spin = parent.spin;
      rate = parent.spin_rate;
    }
    for (std::size_t d = first; d <= link; ++d) {
      const Vec3<S> own = kinematics.axis[d] * qd[d];
      rate += kinematics.axis[d] * qdd[d] + cross(spin, own);
      spin += own;
    }
    piece.spin = spin;
    piece.spin_rate = rate;
    piece.turning = dynamics_detail::turning(spin, rate);
  }
  // in a loop of its own, as these do not wait for each other
  for (std::size_t i = 0; i < count; ++i) {
    const auto& joint = constants.joints[i];
    auto& piece = work.pieces[i];
    if (!joint.massive) {
      piece.carried = {};
      continue;
    }
    const auto link = static_cast<std::size_t>(joint.link);
    const Vec3<S> spin = piece.spin;
    const Mat3<S>& rotation = kinematics.rotation[link];
    const Vec3<S> com =
        joint.upright ? rotation.cy * S(joint.com.y) : rotation * to_scalar<S>(joint.com);
    const Vec3<S> force = (piece.acceleration + piece.turning * com) * S(joint.mass);
    const Vec3<S> angular_momentum = dynamics_detail::inertia_times(joint, rotation, spin);
    piece.carried = {force, dynamics_detail::inertia_times(joint, rotation, piece.spin_rate) +
                                cross(spin, angular_momentum) + cross(com, force)};
    work.mass_moment += (kinematics.origin[link] + com) * S(joint.mass);
  }
  Wrench<S> base;
  base.force = lift * S(constants.base_mass);
  base.moment = cross(base_com, base.force);
  for (std::size_t i = count; i-- > 0;) {
    const auto& joint = constants.joints[i];
    const auto first = static_cast<std::size_t>(joint.first);
    const Wrench<S>& w = work.pieces[i].carried;
    for (std::size_t d = first; d <= static_cast<std::size_t>(joint.link); ++d) {
      tau[d] = dot(kinematics.axis[d], w.moment);
    }
    Vec3<S> arm = kinematics.origin[first];
    Wrench<S>* to = &base;
    if (joint.parent >= 0) {
      const auto p = static_cast<std::size_t>(joint.parent);
      arm = arm - kinematics.origin[static_cast<std::size_t>(constants.joints[p].link)];
      to = &work.pieces[p].carried;
    }
    to->force += w.force;
    to->moment += w.moment + cross(arm, w.force);
  }
  return base;
}

}  // namespace shigusa
