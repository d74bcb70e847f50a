// SPDX-License-Identifier: MIT
#include "scene/thing_shape.hpp"

#include <optional>

#include "math/turn_about.hpp"
#include "problem/request_fields.hpp"
#include "problem/thing_parts.hpp"
#include "scene/boxes.hpp"

namespace shigusa {
namespace {

// Cosine of the tilt (1°) up to which an axis counts as upright.
constexpr double kUprightLeast = 0.99985;
// Share by which the sides of a round thing may differ, and its surface be off its round shape.
constexpr double kRound = 0.03;
// Least thickness (m) of a part: a sheet has none.
constexpr double kPartLeast = 1e-3;
// Share of a box that the boxes of its mesh fill at most if they are its parts.
constexpr double kFilled = 0.85;
// Part of a handle's length, about its middle, that is its bar.
constexpr double kBarShare = 1.0 / 3.0;
// Spacing of points on a handle, as a share of its length.
constexpr double kHandleSpacing = 1.0 / 40.0;

Surface in_own_axes(const Surface& surface, double turn_deg, const Vec3d& origin) {
  const Mat3d axes = turn_about({0, 1, 0}, radians(turn_deg));
  Surface own = surface;
  for (Vec3d& point : own.points) point = transpose_times(axes, point - origin);
  return own;
}

// Whether all points are as near to the middle as those of a round shape, along these axes.
bool is_round(const Surface& surface, const Vec3d& middle, const Vec3d& along, double radius) {
  for (const Vec3d& point : surface.points) {
    const Vec3d off = point - middle;
    const Vec3d out{off.x * along.x, off.y * along.y, off.z * along.z};
    if (norm(out) > radius * (1.0 + kRound)) return false;
  }
  return true;
}

bool are_equal(double a, double b) { return abs(a - b) <= kRound * max(a, b); }

ThingShape shape_of(const Surface& surface, const Bounds& bounds) {
  const Vec3d size = bounds.size();
  if (!are_equal(size.x, size.z)) return ThingShape::box;
  const double radius = 0.5 * max(size.x, size.z);
  const bool even = are_equal(size.x, size.y);
  if (even && is_round(surface, bounds.middle(), {1, 1, 1}, radius)) return ThingShape::sphere;
  return is_round(surface, bounds.middle(), {1, 0, 1}, radius) ? ThingShape::cylinder
                                                               : ThingShape::box;
}

// Middle of the mass within the surface from the middle of its bounds; what is within the precision
// of the cells is none.
Vec3d centre_of(const Surface& surface, const Bounds& bounds) {
  const std::optional<Voxels> voxels = Voxels::of(surface, kSceneCells[0], {});
  if (!voxels) return {};
  Vec3d off = voxels->centre() - bounds.middle();
  for (int k = 0; k < 3; ++k) {
    if (abs(off[k]) < voxels->edge()) off[k] = 0.0;
  }
  return off;
}

// The boxes that a mesh is made of, along its own axes, from its middle; none if they are as good
// as its sides.
std::vector<ThingPart> parts_of_mesh(const Surface& own, const Bounds& bounds) {
  std::vector<ThingPart> parts;
  double filled = 0.0;
  for (const Bounds& box : boxes_of(own, kPartsMax, {}).boxes) {
    ThingPart part{box.middle() - bounds.middle(), box.size()};
    for (int k = 0; k < 3; ++k) part.size[k] = max(part.size[k], kPartLeast);
    filled += volume_of(part);
    parts.push_back(part);
  }
  const Vec3d all = bounds.size();
  if (parts.size() < 2 || filled > kFilled * all.x * all.y * all.z) return {};
  return parts;
}

}  // namespace

double turn_of_thing(const Mat3d& rotation) {
  for (int k = 0; k < 3; ++k) {
    if (abs(rotation.column(k).y) < kUprightLeast) continue;
    const Vec3d& x = k == 0 ? rotation.cy : rotation.cx;
    return degrees(atan2(-x.z, x.x));
  }
  return 0.0;
}

Thing thing_of_surface(const Surface& surface, double turn_deg) {
  const Surface own = in_own_axes(surface, turn_deg, {});
  const Bounds bounds = own.bounds();
  Thing thing;
  thing.turn_deg = turn_deg;
  thing.position = turn_about({0, 1, 0}, radians(turn_deg)) * bounds.middle();
  thing.shape = shape_of(own, bounds);
  thing.size = bounds.size();
  if (thing.shape != ThingShape::box) thing.size.x = thing.size.z = max(thing.size.x, thing.size.z);
  if (thing.shape == ThingShape::sphere) {
    const double side = max(thing.size.x, thing.size.y);
    thing.size = {side, side, side};
  }
  for (int k = 0; k < 3; ++k) thing.size[k] = max(thing.size[k], kThingLeast);
  thing.centre = centre_of(own, bounds);
  if (thing.shape == ThingShape::box) thing.parts = parts_of_mesh(own, bounds);
  return thing;
}

ThingHandle handle_of_surface(const Surface& surface, const Thing& thing) {
  const Surface own = in_own_axes(surface, thing.turn_deg, thing.position);
  const Bounds all = own.bounds();
  int longest = 0;
  for (int k = 1; k < 3; ++k) {
    if (all.size()[k] > all.size()[longest]) longest = k;
  }
  Bounds bar;
  each_point(own, max(kHandleSpacing * all.longest(), 1e-6), [&](const Vec3d& point) {
    const double off = abs(point[longest] - all.middle()[longest]);
    if (off <= 0.5 * kBarShare * all.size()[longest]) bar.add(point);
  });
  ThingHandle handle;
  handle.position = bar.low.x <= bar.high.x ? bar.middle() : all.middle();
  handle.position[longest] = all.middle()[longest];
  handle.along = {};
  handle.along[longest] = 1.0;
  return handle;
}

}  // namespace shigusa
