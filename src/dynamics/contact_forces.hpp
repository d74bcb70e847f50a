// SPDX-License-Identifier: MIT
#pragma once

#include "body/body_constants.hpp"
#include "dynamics/inverse_dynamics.hpp"

namespace shigusa {

// Point of application of the floor's vertical force F, times F: (x F, F, z F) in N·m, N and N·m,
// for a wrench with its moment about the world's origin. Unlike the point itself it is
// well-conditioned for small F.
template <class S>
[[nodiscard]] Vec3<S> pressure(const Wrench<S>& wrench, S floor) {
  const Vec3<S> f = wrench.force;
  return {wrench.moment.z + f.x * floor, f.y, f.z * floor - wrench.moment.x};
}

// Point on the floor (height `floor`, m) about which the floor's wrench has no horizontal moment.
// The wrench's moment is about the world's origin; its vertical force must not be 0 (a body not in
// free fall), and is clamped to at least 1 N.
template <class S>
[[nodiscard]] Vec3<S> centre_of_pressure(const Wrench<S>& wrench, S floor) {
  const S up = max(wrench.force.y, S(1));
  const Vec3<S> p = pressure(wrench, floor);
  return {p.x / up, floor, p.z / up};
}

// Height (m) of the floor that bears the body: of the base's sole, or of the base without one.
[[nodiscard]] double floor_height(const BodyModel& body);

// Lift of a heel, from 0 (down) to 1, from the body's angles (dofs, rad); `toes` is its Heel::toes.
template <class S>
[[nodiscard]] S heel_lifted(int toes, std::span<const S> angles) {
  return clamp(angles[index(toes)] * S(1.0 / kHeelLifts), S(0), S(1));
}

// Midpoint (m, world) of a foot's bearing area: of its sole, or of its forefoot if the heel is
// lifted.
template <class S>
[[nodiscard]] Vec3<S> bearing_centre(const Foot& foot, const Kinematics<S>& kinematics,
                                     std::span<const S> angles) {
  Vec3<S> centre = to_scalar<S>(foot.centre);
  if (foot.heel) {
    centre += to_scalar<S>(foot.heel->forefoot_centre - foot.centre) *
              heel_lifted<S>(foot.heel->toes, angles);
  }
  return kinematics.link_origin(foot.link) + kinematics.link_rotation(foot.link) * centre;
}

// The second foot's part of the ground wrench: its share of the force through the foot, displaced
// by the offset of the centre of pressure from the line between the feet, and its share of the
// remaining moment about the centre of pressure.
template <class S>
[[nodiscard]] Wrench<S> shared_wrench(const Wrench<S>& ground, const Vec3<S>& cop,
                                      const Vec3<S>& on_line, const Vec3<S>& foot, S share) {
  const Vec3<S> force = ground.force * share;
  const Vec3<S> left_over = ground.moment - cross(cop, ground.force);
  return {force, cross(foot + (cop - on_line), force) + left_over * share};
}

// Distributes the floor's wrench between the body's two standing feet by the lever rule along the
// line between them, and subtracts the second foot's part from the joint torques tau (dofs, N·m).
// The first foot is the base. Both parts add up to the wrench exactly. Returns the second foot's
// wrench, moment about the world's origin. `angles` (dofs, rad): of the body, needed for lifted
// heels.
template <class S>
Wrench<S> share_ground_wrench(const BodyModel& body, const Kinematics<S>& kinematics,
                              std::span<const S> angles, const Wrench<S>& ground,
                              std::span<S> tau) {
  const Foot& first = body.feet()[0];
  const Foot& second = body.feet()[1];
  const Vec3<S> a = bearing_centre(first, kinematics, angles);
  const Vec3<S> b = bearing_centre(second, kinematics, angles);
  const Vec3<S> cop = centre_of_pressure(ground, a.y);
  const Vec3<S> line{b.x - a.x, S(0), b.z - a.z};
  const Vec3<S> from{cop.x - a.x, S(0), cop.z - a.z};
  const S share = clamp(dot(from, line) / max(dot(line, line), S(1e-6)), S(0), S(1));
  const Wrench<S> part = shared_wrench(ground, cop, a + line * share, b, share);
  const auto& dofs = body.constants<Element<S>>().dofs;
  Vec3<S> about{};  // moment of the second foot's part about the joint
  for (const int d : body.chain(second.link)) {
    const std::size_t k = index(d);
    if (dofs[k].starts_joint) about = part.moment - cross(kinematics.origin[k], part.force);
    tau[k] = tau[k] - dot(kinematics.axis[k], about);
  }
  return part;
}

// Subtracts the floor's reaction from the joint torques tau (dofs, N·m), which assume the whole
// wrench on the base: the second foot's part (share_ground_wrench) and, for a heel that is down,
// the toes' torque. `angles`: (dofs, rad).
template <class S>
void bear_on_feet(const BodyModel& body, const Kinematics<S>& kinematics, std::span<const S> angles,
                  const Wrench<S>& ground, std::span<S> tau) {
  if (body.feet().size() == 2) share_ground_wrench<S>(body, kinematics, angles, ground, tau);
  for (const Foot& foot : body.feet()) {
    if (!foot.heel) continue;
    S& toes = tau[index(foot.heel->toes)];
    toes = toes * heel_lifted<S>(foot.heel->toes, angles);
  }
}

}  // namespace shigusa
