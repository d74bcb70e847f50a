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
  std::vector<Vec3<S>> spin;          // (dofs) rad/s, world
  std::vector<Vec3<S>> spin_rate;     // (dofs) rad/s², world
  std::vector<Vec3<S>> acceleration;  // (dofs) m/s², of the joint centre, less gravity
  std::vector<Wrench<S>> carried;     // (dofs) through the joint, moment about its centre

  explicit DynamicsWorkspace(const BodyModel& body)
      : spin(body.dofs().size()),
        spin_rate(body.dofs().size()),
        acceleration(body.dofs().size()),
        carried(body.dofs().size()) {}
};

namespace dynamics_detail {

// the wrench that moves one link, moment about its joint centre
template <class S>
[[nodiscard]] Wrench<S> link_wrench(const MassProperties& m, const Mat3<S>& rotation,
                                    const Vec3<S>& spin, const Vec3<S>& spin_rate,
                                    const Vec3<S>& acceleration) {
  const Vec3<S> com = rotation * to_scalar<S>(m.com);
  const Vec3<S> com_acceleration =
      acceleration + cross(spin_rate, com) + cross(spin, cross(spin, com));
  const Vec3<S> force = com_acceleration * S(m.mass);
  const Mat3<S> inertia = to_scalar<S>(m.inertia);
  const auto turn = [&](const Vec3<S>& v) {
    return rotation * (inertia * transpose_times(rotation, v));
  };
  return {force, turn(spin_rate) + cross(spin, turn(spin)) + cross(com, force)};
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
  // accelerating upwards by g replaces the weight
  const Vec3<S> lift{S(0), S(kGravity), S(0)};
  const int n = body.dof_count();
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int parent = body.dof(i).parent;
    const auto p = static_cast<std::size_t>(parent == kBaseLink ? 0 : parent);
    const bool root = parent == kBaseLink;
    const Vec3<S> spin = root ? Vec3<S>{} : work.spin[p];
    const Vec3<S> rate = root ? Vec3<S>{} : work.spin_rate[p];
    const Vec3<S> arm = kinematics.origin[k] - kinematics.link_origin(parent);
    const Vec3<S> own = kinematics.axis[k] * qd[k];
    work.acceleration[k] =
        (root ? lift : work.acceleration[p]) + cross(rate, arm) + cross(spin, cross(spin, arm));
    work.spin[k] = spin + own;
    work.spin_rate[k] = rate + kinematics.axis[k] * qdd[k] + cross(spin, own);
    const MassProperties& mass = body.link_mass(i);
    work.carried[k] = mass.mass > 0.0
                          ? dynamics_detail::link_wrench(mass, kinematics.rotation[k], work.spin[k],
                                                         work.spin_rate[k], work.acceleration[k])
                          : Wrench<S>{};
  }
  const MassProperties& base_mass = body.link_mass(kBaseLink);
  Wrench<S> base;
  base.force = lift * S(base_mass.mass);
  base.moment = cross(kinematics.point(kBaseLink, base_mass.com), base.force);
  for (int i = n - 1; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    const Wrench<S>& w = work.carried[k];
    tau[k] = dot(kinematics.axis[k], w.moment);
    const int parent = body.dof(i).parent;
    Wrench<S>& to = parent == kBaseLink ? base : work.carried[static_cast<std::size_t>(parent)];
    const Vec3<S> from = parent == kBaseLink ? Vec3<S>{} : kinematics.link_origin(parent);
    to.force += w.force;
    to.moment += w.moment + cross(kinematics.origin[k] - from, w.force);
  }
  return base;
}

}  // namespace shigusa
