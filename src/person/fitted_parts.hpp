// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/landmarks.hpp>
#include <shigusa/skeleton.hpp>

#include "person/measure_person.hpp"
#include "skeleton_tree.hpp"

namespace shigusa {

// The shapes of a person's parts by the mesh, as far as it tells them: parts with fewer than a
// dozen vertices are left out, and so are feet, which have the shape of their soles. What is flesh
// and what is cloth a mesh does not tell, so shapes go by what lies all around a bone, not by the
// farthest vertex:
//
// - Around a limb's line, ends excepted, the vertices bound to it or to what hangs on it below the
//   next bone are parted into eight sectors. Each has the distance that three quarters of its
//   vertices do not exceed, and the radius is the middle one of these: what sticks out to one side,
//   a sleeve, a skirt, a sword, changes it little. A leg is no thicker than there is room between
//   the legs.
// - A piece of the trunk, of vertices bound to its own bones alone, is as thick as the lesser of
//   depth and breadth by the middle vertex ahead, behind and at the sides: a capsule cannot be
//   flat, and a cape counts no more than the back.
// - The head is what is bound to its own bone: hair and ears on bones of their own are left out. It
//   is as broad and deep as all but the outermost fiftieth of the vertices at each side.
// - Meshes that hang on bones as a whole count where a part has no others: robots, and no hats.
[[nodiscard]] PartShapes fitted_parts(const SkeletonTree& tree, const HumanoidMap& map,
                                      const MeasuredPerson& person);

}  // namespace shigusa
