// SPDX-License-Identifier: MIT
#pragma once

#include "measure_person.hpp"
#include "rig/skeleton_tree.hpp"

namespace shigusa {

// The shapes of a person's parts by the mesh, as far as it tells them: parts with fewer than a
// dozen vertices are left out, and so are feet, which have the shape of their soles. A mesh
// does not tell flesh from cloth, so shapes go by all that lies around a bone, not by the farthest
// vertex:
//
// - Around a limb's line, ends excepted, the vertices bound to it or to what hangs on it below the
//   next bone are parted into eight sectors. Each has the distance that three quarters of its
//   vertices do not exceed, and the radius is the middle one of these: what sticks out to one side,
//   a sleeve, a skirt, a sword, changes it little. The same in four slices of the limb tells how it
//   tapers. A leg is no thicker than there is room between the legs.
// - A hand that is broader than thick is flat, and ends where nineteen of twenty of its vertices
//   do.
// - A piece of the trunk, of vertices bound to its own bones alone or to those of its flesh, is as
//   thick as the lesser of depth and breadth by three quarters of the vertices ahead and at the
//   sides and by half of those behind, where capes hang; one that is broader is flat, by up to
//   twice as broad as deep.
// - The head is what is bound to its own bone: hair and ears on bones of their own are left out. It
//   is as broad and deep as the vertices without the outermost fiftieth at each side.
// - Meshes that hang on bones as a whole count where a part has no others: robots, and no hats.
[[nodiscard]] PartShapes fitted_parts(const SkeletonTree& tree, const HumanoidMap& map,
                                      const MeasuredPerson& person);

}  // namespace shigusa
