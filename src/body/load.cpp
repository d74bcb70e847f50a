// SPDX-License-Identifier: MIT
#include "load.hpp"

#include <shigusa/goal.hpp>

#include "core/check.hpp"
#include "link_mass.hpp"

namespace shigusa {

BodyModel with_load(const BodyModel& body, const HeldLoad& load) {
  SHG_CHECK(load.mass >= 0.0 && load.mass <= kLoadMax, "a load within its range");
  SHG_CHECK(load.effector >= 0 && load.effector < body.effector_count(), "an effector's load");
  const Effector& hand = body.effector(load.effector);
  SHG_CHECK(hand.link != kBaseLink, "a load on a link that moves");
  BodyDefinition loaded = body.definition();
  MassProperties& link = loaded.masses[static_cast<std::size_t>(hand.link)];
  LinkMass sum = link_mass(link);
  sum.add(point_mass(load.mass, hand.point));
  const Mat3d upright{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (sum.mass > 0.0) link = sum.in_frame(upright, {});
  loaded.mass += load.mass;
  return BodyModel(std::move(loaded));
}

double heaviest_load(const State& state) {
  double heaviest = 0.0;
  for (const HeldLoad& load : state.held) heaviest = max(heaviest, load.mass);
  return heaviest;
}

}  // namespace shigusa
