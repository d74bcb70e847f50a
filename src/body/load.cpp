// SPDX-License-Identifier: MIT
#include "load.hpp"

#include <shigusa/goal.hpp>

#include "core/check.hpp"
#include "link_mass.hpp"

namespace shigusa {

BodyModel with_load(const BodyModel& body, int effector, double load) {
  SHG_CHECK(load >= 0.0 && load <= kLoadMax, "a load within its range");
  const Effector& hand = body.effector(effector);
  SHG_CHECK(hand.link != kBaseLink, "a load on a link that moves");
  BodyDefinition loaded = body.definition();
  MassProperties& link = loaded.masses[static_cast<std::size_t>(hand.link)];
  LinkMass sum = link_mass(link);
  sum.add(point_mass(load, hand.point));
  const Mat3d upright{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (sum.mass > 0.0) link = sum.in_frame(upright, {});
  loaded.mass += load;
  loaded.load = max(loaded.load, load);
  return BodyModel(std::move(loaded));
}

}  // namespace shigusa
