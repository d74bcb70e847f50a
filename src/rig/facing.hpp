// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>

#include "skeleton_tree.hpp"

namespace shigusa {

// The tip of a foot among the nodes below its ankle: of what is called toes the farthest, else the
// farthest that is no heel. The ankle itself where nothing but a heel follows, and where the mesh
// of the foot lies on the other side of it: what is there is a heel, whatever it is called.
[[nodiscard]] int foot_tip(const SkeletonTree& tree, int knee, int ankle);

// Where a foot reaches from its ankle: to its tip, or without one to where its mesh is; 0 where it
// has neither.
[[nodiscard]] Vec3d foot_from(const SkeletonTree& tree, int knee, int ankle);

// Whether a body is the mirror image of what its names say: left is on its right. Feet that point
// backwards, seen from the left and right of the names, are the mark of it where nothing else of
// the body says the contrary: a face with eyes, a jaw or a nose, the middle of the head's mesh,
// knees, elbows and thumbs, breasts and a tail. Where feet do not tell, face and another sign do.
// Bending hips, knees or trunk does not change the answer.
[[nodiscard]] bool is_mirrored(const SkeletonTree& tree, const HumanoidMap& map);

}  // namespace shigusa
