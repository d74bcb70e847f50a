// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>

#include "skeleton_tree.hpp"

namespace shigusa {

// Tip of a foot among the descendants of its ankle: the farthest one named as toes, else the
// farthest that is no heel. It is the ankle itself if there is only a heel, or if the foot's mesh
// lies on the other side of the ankle, which makes the node a heel whatever its name.
[[nodiscard]] int foot_tip(const SkeletonTree& tree, int knee, int ankle);

// Vector from the ankle of a foot to its tip, or without one to its mesh; 0 without either.
[[nodiscard]] Vec3d foot_from(const SkeletonTree& tree, int knee, int ankle);

// Whether a body is the mirror image of its names, with left on its right side. Feet that point
// backwards, in terms of the names' left and right, indicate it unless the rest of the body
// contradicts: a face with eyes, a jaw or a nose, the middle of the head's mesh, knees, elbows and
// thumbs, breasts and a tail. If the feet are inconclusive, the face and another sign decide. Bent
// hips, knees or trunk do not change the answer.
[[nodiscard]] bool is_mirrored(const SkeletonTree& tree, const HumanoidMap& map);

}  // namespace shigusa
