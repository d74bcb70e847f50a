// SPDX-License-Identifier: MIT
#include "work/moment.hpp"

#include <algorithm>

#include "math/turn_about.hpp"
#include "problem/thing_parts.hpp"

namespace shigusa {
namespace {

// Inertia (kg·m²) of a box about its middle along its sides (m).
Vec3d inertia_of_box(double mass, const Vec3d& s) {
  return Vec3d{s.y * s.y + s.z * s.z, s.x * s.x + s.z * s.z, s.x * s.x + s.y * s.y} * (mass / 12.0);
}

// Inertia (kg·m²) of parts about their centre along the own axes, of even density.
Vec3d inertia_of_parts(double mass, std::span<const ThingPart> parts) {
  const Vec3d centre = centre_of(parts);
  double all = 0.0;
  for (const ThingPart& part : parts) all += volume_of(part);
  Vec3d sum{};
  for (const ThingPart& part : parts) {
    const double own = mass * volume_of(part) / all;
    const Vec3d off = part.position - centre;
    sum += inertia_of_box(own, part.size);
    sum += Vec3d{off.y * off.y + off.z * off.z, off.x * off.x + off.z * off.z,
                 off.x * off.x + off.y * off.y} *
           own;
  }
  return sum;
}

// Inertia (kg·m²) about the middle along the own axes, of even density.
Vec3d inertia_of(const Thing& thing) {
  if (!thing.parts.empty()) return inertia_of_parts(thing.mass, thing.parts);
  const double m = thing.mass;
  const Vec3d& s = thing.size;
  switch (thing.shape) {
    case ThingShape::box:
      return inertia_of_box(m, s);
    case ThingShape::cylinder: {
      const double across = m * (3.0 * 0.25 * s.x * s.x + s.y * s.y) / 12.0;
      return {across, m * s.x * s.x / 8.0, across};
    }
    case ThingShape::sphere: {
      const double all = m * s.x * s.x / 10.0;
      return {all, all, all};
    }
  }
  return {};
}

// Radius (m) of a thing's round edges.
double radius_of(const Thing& thing) {
  switch (thing.shape) {
    case ThingShape::box:
      return 0.0;
    case ThingShape::cylinder:
      return 0.5 * min(thing.size.x, thing.size.y);
    case ThingShape::sphere:
      return 0.5 * thing.size.x;
  }
  return 0.0;
}

// Sides (m) without round edges.
Vec3d inner_size(const Thing& thing) {
  const double off = 2.0 * radius_of(thing);
  return {max(thing.size.x - off, 0.0), max(thing.size.y - off, 0.0), max(thing.size.z - off, 0.0)};
}

// The form of a thing in collisions: its parts, or its shape.
std::vector<HeldPart> form_of(const Thing& thing) {
  if (thing.parts.empty()) return {{{}, inner_size(thing), radius_of(thing)}};
  std::vector<HeldPart> form;
  for (const ThingPart& part : thing.parts) form.push_back({part.position, part.size, 0.0});
  return form;
}

}  // namespace

std::vector<Grip> Moment::on(std::size_t thing) const {
  std::vector<Grip> own;
  std::copy_if(grips.begin(), grips.end(), std::back_inserter(own),
               [thing](const Grip& grip) { return grip.thing == thing; });
  return own;
}

std::optional<std::size_t> Moment::in(int hand) const {
  for (const Grip& grip : grips) {
    if (grip.hand == hand) return grip.thing;
  }
  return std::nullopt;
}

Transformd upright_pose(const Vec3d& position, double turn_deg) {
  return {turn_about({0, 1, 0}, radians(turn_deg)), position};
}

Transformd start_pose(const Thing& thing) { return upright_pose(thing.position, thing.turn_deg); }

Transformd held_pose(const Kinematics<double>& placed, std::span<const Grip> grips) {
  const auto by = [&placed](const Grip& grip) {
    return Transformd{placed.link_rotation(grip.link), placed.link_origin(grip.link)} *
           grip.in_hand;
  };
  Transformd pose = by(grips.front());
  const double share = 1.0 / static_cast<double>(grips.size());
  Vec3d middle = pose.translation * share;
  Vec3d turn{};
  for (const Grip& grip : grips.subspan(1)) {
    const Transformd other = by(grip);
    middle += other.translation * share;
    turn += rotation_vector(other.rotation * transpose(pose.rotation)) * share;
  }
  return {turn_about(normalized(turn, {0, 1, 0}), norm(turn)) * pose.rotation, middle};
}

HeldLoad load_of(const BodyModel& body, const Thing& thing, const Grip& grip, std::size_t hands,
                 bool first) {
  const double share = 1.0 / static_cast<double>(hands);
  const Vec3d point = body.effector(grip.hand).point;
  HeldLoad load{.effector = grip.hand,
                .mass = thing.mass * share,
                .centre = grip.in_hand * thing.centre - point,
                .turn = to_quat(grip.in_hand.rotation),
                .inertia = inertia_of(thing) * share};
  if (!first) return load;
  load.name = thing.name;
  load.middle = grip.in_hand.translation - point;
  load.parts = form_of(thing);
  return load;
}

std::vector<Obstacle> obstacles_of(const Thing& thing, const Transformd& pose) {
  std::vector<Obstacle> obstacles;
  for (const HeldPart& part : form_of(thing)) {
    obstacles.push_back({.name = thing.name,
                         .position = pose * part.offset,
                         .rotation = to_quat(pose.rotation),
                         .size = part.size,
                         .radius = part.radius});
  }
  return obstacles;
}

State state_of(const BodyModel& body, std::span<const Thing> things, const Moment& moment) {
  State state{.angles = moment.angles, .velocities = {}, .held = {}};
  for (std::size_t t = 0; t < things.size(); ++t) {
    const std::vector<Grip> grips = moment.on(t);
    for (std::size_t g = 0; g < grips.size(); ++g) {
      state.held.push_back(load_of(body, things[t], grips[g], grips.size(), g == 0));
    }
  }
  return state;
}

}  // namespace shigusa
