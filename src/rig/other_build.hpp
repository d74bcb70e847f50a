// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/motion.hpp>

#include "skeleton_tree.hpp"

namespace shigusa {

// Why a skeleton in which a person's limbs were found is another creature's, by what else it has
// and how its limbs are called; empty where it may be a person's. `by_names`: that of all limbs
// the names told which they are.
//
// - Limbs that are called an animal's (FrontLeg, Hind_Leg, Wing, Fin), or both of a pair fingers'.
// - Arms that hang on a head or a jaw.
// - Further legs or arms by their names, that stand apart from the person's.
// - Without names two more pairs of chains of legs' length that reach the floor: crabs and spiders.
// - A level trunk over four limbs that reach down alike, with a tail or without names.
[[nodiscard]] Message unlike_a_persons_build(const SkeletonTree& tree, const HumanoidMap& map,
                                             bool by_names);

}  // namespace shigusa
