// SPDX-License-Identifier: MIT
#include "link_mass.hpp"

namespace shigusa {

Mat3d outer(const Vec3d& a, const Vec3d& b) { return {a * b.x, a * b.y, a * b.z}; }

Mat3d scaled(const Mat3d& m, double s) { return {m.cx * s, m.cy * s, m.cz * s}; }

namespace {

// Inertia about the origin of a point mass at p: m (|p|² 1 - p pᵀ).
Mat3d point_inertia(double mass, const Vec3d& p) {
  const double d = dot(p, p);
  return scaled(Mat3d{{d, 0, 0}, {0, d, 0}, {0, 0, d}} + scaled(outer(p, p), -1.0), mass);
}

}  // namespace

LinkMass LinkMass::of(double mass, const Vec3d& com, const Mat3d& inertia) {
  return {mass, com * mass, inertia + point_inertia(mass, com)};
}

void LinkMass::add(const LinkMass& other) {
  mass += other.mass;
  moment += other.moment;
  about_origin = about_origin + other.about_origin;
}

void LinkMass::take_off(const LinkMass& part) {
  mass -= part.mass;
  moment = moment - part.moment;
  about_origin = about_origin + scaled(part.about_origin, -1.0);
}

LinkMass LinkMass::shifted(const Vec3d& by) const {
  const Vec3d com = moment * (1.0 / mass);
  const Mat3d about_com = about_origin + scaled(point_inertia(mass, com), -1.0);
  return {mass, moment + by * mass, about_com + point_inertia(mass, com + by)};
}

MassProperties LinkMass::in_frame(const Mat3d& frame, const Vec3d& origin) const {
  if (!(mass > 0.0)) return {};
  const Vec3d com = moment * (1.0 / mass);
  const Mat3d about_com = about_origin + scaled(point_inertia(mass, com), -1.0);
  return {mass, transpose_times(frame, com - origin), transpose(frame) * about_com * frame};
}

LinkMass link_mass(const MassProperties& mass) {
  return {mass.mass, mass.com * mass.mass, mass.inertia + point_inertia(mass.mass, mass.com)};
}

LinkMass point_mass(double mass, const Vec3d& at) {
  return {mass, at * mass, point_inertia(mass, at)};
}

}  // namespace shigusa
