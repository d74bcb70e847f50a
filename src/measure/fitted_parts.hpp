// SPDX-License-Identifier: MIT
#pragma once

#include "measure_person.hpp"
#include "rig/skeleton_tree.hpp"

namespace shigusa {

// Shapes of a person's parts from the mesh. Parts with fewer than a dozen vertices are left out,
// and so are feet, which have the shape of their soles. A mesh does not distinguish flesh from
// cloth, so shapes use all vertices around a bone rather than the farthest one:
//
// - Around a limb's axis, except at its ends, the vertices bound to it or to descendants above the
//   next bone are divided into eight sectors. A sector's distance is the three-quarter quantile of
//   its vertices, and the radius is the median over the sectors, which protrusions to one side,
//   such as a sleeve, a skirt or a sword, hardly change. The same in four slices of the limb gives
//   its taper. A leg is no thicker than the space between the legs.
// - A hand that is broader than thick is flat, and ends at the 0.95 quantile of its vertices.
// - A piece of the trunk uses vertices bound to its own bones alone or to those of its flesh. Its
//   thickness is the lesser of depth and breadth, by three quarters of the vertices ahead and at
//   the sides and by half of those behind, where capes hang; a broader one is flat, up to twice as
//   broad as deep.
// - The head uses the vertices bound to its own bone: hair and ears on separate bones are left out.
//   Breadth and depth leave out the outermost fiftieth at each side.
// - Meshes rigidly attached to bones count if a part has no others: this includes robots and
//   excludes hats.
[[nodiscard]] PartShapes fitted_parts(const SkeletonTree& tree, const HumanoidMap& map,
                                      const MeasuredPerson& person);

}  // namespace shigusa
