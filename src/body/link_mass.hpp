// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>

namespace shigusa {

// Outer product a bᵀ.
[[nodiscard]] Mat3d outer(const Vec3d& a, const Vec3d& b);
[[nodiscard]] Mat3d scaled(const Mat3d& m, double s);

// Mass of one or several segments in the start posture, in world coordinates, in which sums are
// exact; it is transformed to a link's frame at the end.
struct LinkMass {
  double mass = 0.0;                                    // kg
  Vec3d moment{};                                       // kg·m, mass × com
  Mat3d about_origin{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  // kg·m², about the world's origin

  // `inertia`: kg·m², about the centre of mass `com` (m)
  [[nodiscard]] static LinkMass of(double mass, const Vec3d& com, const Mat3d& inertia);

  void add(const LinkMass& other);
  // a fraction of it
  void take_off(const LinkMass& part);
  // the same mass translated
  [[nodiscard]] LinkMass shifted(const Vec3d& by) const;
  [[nodiscard]] MassProperties in_frame(const Mat3d& frame, const Vec3d& origin) const;
};

// Mass properties in the link's frame.
[[nodiscard]] LinkMass link_mass(const MassProperties& mass);
[[nodiscard]] LinkMass point_mass(double mass, const Vec3d& at);

}  // namespace shigusa
