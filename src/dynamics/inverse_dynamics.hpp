// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "body/body_constants.hpp"
#include "core/index.hpp"
#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

inline constexpr double kGravity = 9.80665;  // m/s², standard

// A force and its moment about a stated point, world axes.
template <class S>
struct Wrench {
  Vec3<S> force{};   // N
  Vec3<S> moment{};  // N·m
};

// Rates of a body's joint angles.
template <class S>
struct JointRates {
  std::span<const S> speeds;         // (dofs) rad/s
  std::span<const S> accelerations;  // (dofs) rad/s²
};

// Motion of a rigid link, in a given frame.
template <class S>
struct Movement {
  Vec3<S> spin{};          // rad/s
  Vec3<S> spin_rate{};     // rad/s²
  Vec3<S> acceleration{};  // m/s², of the joint's centre, minus gravity
};

// Scratch memory of inverse_dynamics; one per thread.
template <class S>
struct DynamicsWorkspace {
  // One rigid link of the body (BodyConstants::Joint), in its own frame.
  struct Piece {
    Movement<S> movement;
    // 1/s²: times a point's position in the link, its acceleration relative to the joint's centre;
    // only cy for an upright link
    Mat3<S> turning{};
    Wrench<S> carried{};  // through the joint, moment about its centre
  };
  std::vector<Piece> pieces;
  // Σ mass · position of the links' centres of mass (kg·m, world), including the base: a by-product
  Vec3<S> mass_moment{};

  explicit DynamicsWorkspace(const BodyModel& body)
      : pieces(body.constants<Element<S>>().joints.size()) {}
};

// Centre of mass of the whole body (m, world) at the last placement of inverse_dynamics.
template <class S>
[[nodiscard]] Vec3<S> centre_of_mass(const BodyModel& body, const DynamicsWorkspace<S>& work) {
  return work.mass_moment * S(Element<S>(1) / body.constants<Element<S>>().total_mass);
}

namespace dynamics_detail {

// Column y of [α]× + [ω]× [ω]×.
template <class S>
[[nodiscard]] Vec3<S> turning_y(const Vec3<S>& spin, const Vec3<S>& rate) {
  return {spin.x * spin.y - rate.z, -(spin.x * spin.x + spin.z * spin.z), spin.y * spin.z + rate.x};
}

// [α]× + [ω]× [ω]×: acceleration of a rigid link's points per position.
template <class S>
[[nodiscard]] Mat3<S> turning(const Vec3<S>& spin, const Vec3<S>& rate) {
  const S xy = spin.x * spin.y;
  const S xz = spin.x * spin.z;
  const S yz = spin.y * spin.z;
  const S yy = spin.y * spin.y;
  return {{-(yy + spin.z * spin.z), xy + rate.z, xz - rate.y},
          turning_y(spin, rate),
          {xz + rate.y, yz - rate.x, -(spin.x * spin.x + yy)}};
}

template <class S, class T>
[[nodiscard]] Vec3<S> cross_place(const Vec3<T>& place, const Vec3<S>& force, bool upright) {
  if (!upright) return cross(to_scalar<S>(place), force);
  return {force.z * S(place.y), S(0), -(force.x * S(place.y))};
}

template <class S>
[[nodiscard]] S component(const Vec3<S>& v, Axis axis) {
  return axis == Axis::x ? v.x : axis == Axis::y ? v.y : v.z;
}

// Transforms a movement across one more dof with velocity qd and acceleration qdd. In place and by
// coordinates, as aggregates would go through memory.
template <class S>
[[gnu::always_inline]] inline void turn_on(Movement<S>& m, Axis axis, const SinCos<S>& turn,
                                           const S& qd, const S& qdd) {
  Vec3<S>& w = m.spin;
  Vec3<S>& r = m.spin_rate;
  turn_back(w, axis, turn);
  turn_back(r, axis, turn);
  turn_back(m.acceleration, axis, turn);
  switch (axis) {
    case Axis::x:
      r.x = r.x + qdd;
      r.y = r.y + w.z * qd;
      r.z = r.z - w.y * qd;
      w.x = w.x + qd;
      break;
    case Axis::y:
      r.x = r.x - w.z * qd;
      r.y = r.y + qdd;
      r.z = r.z + w.x * qd;
      w.y = w.y + qd;
      break;
    default:
      r.x = r.x + w.y * qd;
      r.y = r.y - w.x * qd;
      r.z = r.z + qdd;
      w.z = w.z + qd;
  }
}

// The movement in a frame rotated by the inverse of `to`. Rarely needed, and kept out of line, as
// it would force the movements of all joints into memory.
template <class S, class T>
[[nodiscard, gnu::noinline]] Movement<S> seen_from(const Movement<S>& m, const Mat3<T>& to) {
  const Mat3<S> r = to_scalar<S>(to);
  return {r * m.spin, r * m.spin_rate, r * m.acceleration};
}

// Moment for the rotation of the link about its centre of mass: I α + ω × I ω.
template <class S, class Joint>
[[nodiscard]] Vec3<S> spinning_moment(const Joint& joint, const Movement<S>& m) {
  const Vec3<S>& spin = m.spin;
  const Vec3<S>& rate = m.spin_rate;
  if (!joint.principal) {
    const Mat3<S> inertia = to_scalar<S>(joint.inertia);
    return inertia * rate + cross(spin, inertia * spin);
  }
  return {rate.x * S(joint.inertia.cx.x) + spin.y * spin.z * S(joint.gyroscopic.x),
          rate.y * S(joint.inertia.cy.y) + spin.x * spin.z * S(joint.gyroscopic.y),
          rate.z * S(joint.inertia.cz.z) + spin.x * spin.y * S(joint.gyroscopic.z)};
}

// Transforms the movement across all dofs of a joint. With another signature, movement and rates
// would go through memory, which costs 2 % of a motion.
template <class S>
[[gnu::always_inline]] inline void pass_joint(Movement<S>& m, std::size_t i,
                                              const BodyConstants<Element<S>>& constants,
                                              const Kinematics<S>& kinematics,
                                              JointRates<S> rates) {
  const auto& joint = constants.joints[i];
  if (joint.slants) m = seen_from(Movement<S>(m), transpose(constants.turns[i]));
  for (std::size_t d = index(joint.first); d <= index(joint.link); ++d) {
    const auto& dof = constants.dofs[d];
    turn_on(m, dof.axis, kinematics.turn[d], dof.negative ? -rates.speeds[d] : rates.speeds[d],
            dof.negative ? -rates.accelerations[d] : rates.accelerations[d]);
  }
  if (joint.slants) m = seen_from(Movement<S>(m), constants.turns[i]);
}

// Outward pass from the base: the movement of each link, and the wrench of its own mass at its
// joint. `lift` (m/s², of the base, in its frame): an upward acceleration by g replaces the weight.
template <class S>
[[gnu::always_inline]] inline void pass_outwards(const BodyConstants<Element<S>>& constants,
                                                 const Kinematics<S>& kinematics,
                                                 JointRates<S> rates, const Vec3<S>& lift,
                                                 DynamicsWorkspace<S>& work) {
  Vec3<S> mass_moment = kinematics.point(kBaseLink, constants.base_com) * S(constants.base_mass);
  const typename DynamicsWorkspace<S>::Piece base{{{}, {}, lift}, {{}, {}, {}}, {}};
  for (std::size_t i = 0; i < constants.joints.size(); ++i) {
    const auto& joint = constants.joints[i];
    auto& piece = work.pieces[i];
    const auto& parent = joint.parent < 0 ? base : work.pieces[index(joint.parent)];
    const auto& offset = constants.dofs[index(joint.first)].offset;
    const Vec3<S> carried = times_place(parent.turning, offset, joint.hangs);
    const Movement<S>& p = parent.movement;
    Movement<S> m{{p.spin.x, p.spin.y, p.spin.z},
                  {p.spin_rate.x, p.spin_rate.y, p.spin_rate.z},
                  p.acceleration + carried};
    pass_joint(m, i, constants, kinematics, rates);
    piece.movement.spin = m.spin;
    piece.movement.spin_rate = m.spin_rate;
    piece.movement.acceleration = m.acceleration;
    Mat3<S> turns{{}, {}, {}};
    if (joint.upright) {
      turns.cy = turning_y(m.spin, m.spin_rate);
      piece.turning.cy = turns.cy;
    } else {
      turns = turning(m.spin, m.spin_rate);
      piece.turning = turns;
    }
    if (!joint.massive) {
      piece.carried = {};
      continue;
    }
    const Vec3<S> force =
        (m.acceleration + times_place(turns, joint.com, joint.upright)) * S(joint.mass);
    piece.carried = {force,
                     spinning_moment(joint, m) + cross_place(joint.com, force, joint.upright)};
    const std::size_t link = index(joint.link);
    mass_moment += (kinematics.origin[link] +
                    times_place(kinematics.rotation[link], joint.com, joint.upright)) *
                   S(joint.mass);
  }
  work.mass_moment = mass_moment;
}

// Inward pass from the tips: the torque of each joint. Adds the wrenches of the base's joints to
// `base`, in the base's frame.
template <class S>
[[gnu::always_inline]] inline void pass_inwards(const BodyConstants<Element<S>>& constants,
                                                const Kinematics<S>& kinematics,
                                                DynamicsWorkspace<S>& work, std::span<S> tau,
                                                Wrench<S>& base) {
  // kept in registers for the joint before
  Vec3<S> passed_force{};
  Vec3<S> passed_moment{};
  for (std::size_t i = constants.joints.size(); i-- > 0;) {
    const auto& joint = constants.joints[i];
    const std::size_t first = index(joint.first);
    Vec3<S> force = work.pieces[i].carried.force + passed_force;
    Vec3<S> moment = work.pieces[i].carried.moment + passed_moment;
    if (joint.slants) {
      const Mat3<S> turn = to_scalar<S>(constants.turns[i]);
      force = transpose_times(turn, force);
      moment = transpose_times(turn, moment);
    }
    for (std::size_t d = index(joint.link) + 1; d-- > first;) {
      const auto& dof = constants.dofs[d];
      const S along = component(moment, dof.axis);
      tau[d] = dof.negative ? -along : along;
      turn_forth(force, dof.axis, kinematics.turn[d]);
      turn_forth(moment, dof.axis, kinematics.turn[d]);
    }
    if (joint.slants) {
      const Mat3<S> turn = to_scalar<S>(constants.turns[i]);
      force = turn * force;
      moment = turn * moment;
    }
    const bool at_base = joint.parent < 0;
    const std::size_t p = at_base ? 0 : index(joint.parent);
    moment += cross_place(constants.dofs[first].offset, force, joint.hangs);
    const bool next = !at_base && p + 1 == i;
    passed_force = next ? force : Vec3<S>{};
    passed_moment = next ? moment : Vec3<S>{};
    if (next) continue;
    Wrench<S>& to = at_base ? base : work.pieces[p].carried;
    to.force += force;
    to.moment += moment;
  }
}

}  // namespace dynamics_detail

// Joint torques of a body on its fixed base by the recursive Newton-Euler algorithm: tau_i is the
// torque of joint i (N·m, positive towards larger angles) for these velocities and accelerations at
// the placement `kinematics`, under gravity along -Y. Returns the floor's wrench on the base,
// moment about the world's origin.
// Source: R. Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 5; each link in its own
// frame, where its constants are mostly 0.
template <class S>
Wrench<S> inverse_dynamics(const BodyModel& body, const Kinematics<S>& kinematics,
                           JointRates<S> rates, DynamicsWorkspace<S>& work, std::span<S> tau) {
  const BodyConstants<Element<S>>& constants = body.constants<Element<S>>();
  const Vec3<S> lift = transpose_times(kinematics.base_rotation, Vec3<S>{S(0), S(kGravity), S(0)});
  dynamics_detail::pass_outwards(constants, kinematics, rates, lift, work);
  Wrench<S> base;
  base.force = lift * S(constants.base_mass);
  base.moment = cross(to_scalar<S>(constants.base_com), base.force);
  dynamics_detail::pass_inwards(constants, kinematics, work, tau, base);
  base.force = kinematics.base_rotation * base.force;
  base.moment = kinematics.base_rotation * base.moment + cross(kinematics.base_origin, base.force);
  return base;
}

}  // namespace shigusa
