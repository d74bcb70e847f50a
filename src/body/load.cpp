// SPDX-License-Identifier: MIT
#include "load.hpp"

#include <shigusa/goal.hpp>
#include <utility>
#include <vector>

#include "core/check.hpp"
#include "link_mass.hpp"

namespace shigusa {
namespace {

// Radius of the capsules along a thing's edges, as a share of its shortest side; chosen, so that
// five of them fill a box but for its ends.
constexpr double kEdge = 0.25;

// Capsules of a part of a thing on a hand's link, for obstacles and the floor: one along its
// longest side, and where it has edges four along these.
std::vector<Capsule> capsules_of(const HeldLoad& load, const HeldPart& part, const Effector& hand) {
  const Mat3d turn = to_matrix(load.turn);
  int along = 0;
  for (const int k : {1, 2}) {
    if (part.size[k] > part.size[along]) along = k;
  }
  const int a = (along + 1) % 3;
  const int b = (along + 2) % 3;
  std::vector<Capsule> capsules;
  const auto add = [&](double radius, double at_a, double at_b) {
    Vec3d half{};
    half[along] = max(0.5 * part.size[along] - (radius - part.radius), 0.0);
    Vec3d off{};
    off[a] = at_a;
    off[b] = at_b;
    const Vec3d middle = hand.point + load.middle + turn * part.offset;
    capsules.push_back({.name = load.name,
                        .link = hand.link,
                        .from = middle + turn * (off - half),
                        .to = middle + turn * (off + half),
                        .radius = radius,
                        .of_thing = true});
  };
  const double thin = 0.5 * min(part.size[a], part.size[b]);
  add(max(thin + part.radius, 1e-3), 0.0, 0.0);
  if (thin <= 0.0) return capsules;
  const double edge = max(2.0 * kEdge * thin, 1e-3) + part.radius;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      add(edge, x * (0.5 * part.size[a] - edge + part.radius),
          y * (0.5 * part.size[b] - edge + part.radius));
    }
  }
  return capsules;
}

}  // namespace

BodyModel with_load(const BodyModel& body, const HeldLoad& load) {
  SHG_CHECK(load.mass >= 0.0 && load.mass <= kLoadMax, "a load within its range");
  SHG_CHECK(load.effector >= 0 && load.effector < body.effector_count(), "an effector's load");
  const Effector& hand = body.effector(load.effector);
  SHG_CHECK(hand.link != kBaseLink, "a load on a link that moves");
  BodyDefinition loaded = body.definition();
  MassProperties& link = loaded.masses[static_cast<std::size_t>(hand.link)];
  LinkMass sum = link_mass(link);
  const Mat3d turn = to_matrix(load.turn);
  const Mat3d axes{turn.cx * load.inertia.x, turn.cy * load.inertia.y, turn.cz * load.inertia.z};
  sum.add(LinkMass::of(load.mass, hand.point + load.centre, axes * transpose(turn)));
  const Mat3d upright{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (sum.mass > 0.0) link = sum.in_frame(upright, {});
  loaded.mass += load.mass;
  for (const HeldPart& part : load.parts) {
    for (Capsule& capsule : capsules_of(load, part, hand)) {
      loaded.capsules.push_back(std::move(capsule));
    }
    const Vec3d middle = hand.point + load.middle + turn * part.offset;
    loaded.held.push_back({load.name, hand.link, middle, load.turn, part.size, part.radius});
  }
  return BodyModel(std::move(loaded));
}

double heaviest_load(const State& state) {
  double heaviest = 0.0;
  for (const HeldLoad& load : state.held) heaviest = max(heaviest, load.mass);
  return heaviest;
}

}  // namespace shigusa
