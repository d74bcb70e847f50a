// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/action.hpp>
#include <span>
#include <vector>

namespace shigusa {

// Volume (m³) of a part.
[[nodiscard]] inline double volume_of(const ThingPart& part) {
  return part.size.x * part.size.y * part.size.z;
}

// Centre of mass (m) of parts of even density, from the middle of their thing.
[[nodiscard]] inline Vec3d centre_of(std::span<const ThingPart> parts) {
  double all = 0.0;
  Vec3d sum{};
  for (const ThingPart& part : parts) {
    all += volume_of(part);
    sum += part.position * volume_of(part);
  }
  return all > 0.0 ? sum * (1.0 / all) : sum;
}

// The parts of a thing as boxes of their own, or the thing itself. Their positions are from the
// middle of the thing, along its own axes.
[[nodiscard]] inline std::vector<Thing> split(const Thing& thing) {
  std::vector<Thing> things;
  for (const ThingPart& part : thing.parts) {
    Thing& own = things.emplace_back();
    own.name = thing.name;
    own.size = part.size;
    own.position = part.position;
  }
  if (!things.empty()) return things;
  things.push_back(thing);
  things.back().position = {};
  return things;
}

}  // namespace shigusa
