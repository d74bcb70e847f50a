// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/action.hpp>

#include "scene/surface.hpp"

namespace shigusa {

// Axes of a thing whose node is turned by `rotation` (R_WN): turned about +Y alone. A node of which
// no axis is upright has the world's axes.
[[nodiscard]] double turn_of_thing(const Mat3d& rotation);

// A thing with this surface (m, in the world), its sides turned about +Y by `turn_deg`: a sphere or
// a cylinder if it is as round as one, else a box. It has no name and no mass.
[[nodiscard]] Thing thing_of_surface(const Surface& surface, double turn_deg);

// The bar of a handle with this surface (m, in the world): the middle of its part farthest out,
// along its longest side.
[[nodiscard]] ThingHandle handle_of_surface(const Surface& surface, const Thing& thing);

}  // namespace shigusa
