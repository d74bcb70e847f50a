// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/motion.hpp>

#include "skeleton_tree.hpp"

namespace shigusa {

// Reason why a skeleton in which a person's limbs were found is another creature's, from its other
// limbs and its names; empty if it may be a person's. `by_names`: whether names identified all
// limbs. Reasons are:
//
// - Limbs named as an animal's (FrontLeg, Hind_Leg, Wing, Fin), or both of a pair as fingers.
// - Arms below a head or a jaw.
// - Further legs or arms by their names, apart from the person's.
// - Without names, two more pairs of chains of a leg's length that reach the floor: crabs and
//   spiders.
// - A level trunk over four limbs that reach down equally, with a tail or without names.
[[nodiscard]] Message unlike_a_persons_build(const SkeletonTree& tree, const HumanoidMap& map,
                                             bool by_names);

}  // namespace shigusa
