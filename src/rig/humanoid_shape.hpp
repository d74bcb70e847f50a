// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>

#include "skeleton_tree.hpp"

namespace shigusa {

// Two chains of about the same shape that leave one node.
struct BranchPair {
  int node = -1;
  std::array<int, 2> branch{};  // the first node of each, children of `node`
  double length = 0.0;          // of the shorter one, from `node` to its tip
};

// A body without names: two legs and, above them, two arms.
struct BodyShape {
  BranchPair legs;
  BranchPair arms;
};

// Thigh, shank and foot, or upper arm, forearm and hand.
using LimbNodes = std::array<int, 3>;

// Whether a pair may be the legs (true) or the arms.
using MayBeLimbs = std::function<bool(const BranchPair&, bool legs)>;

// The two pairs of limbs with the longest chains, such that the arms hang on another branch than
// the legs: below the node of the legs, at it, or (the root stands in the chest) above it.
[[nodiscard]] std::optional<BodyShape> find_body_shape(const SkeletonTree& tree,
                                                       const MayBeLimbs& may_be);

// The pair with the longest chains that hangs on other branches than `other`.
[[nodiscard]] std::optional<BranchPair> longest_pair(
    const SkeletonTree& tree, const BranchPair& other,
    const std::function<bool(const BranchPair&)>& may_be);

// The joints of a pair of limbs, by the proportions of people: a joint is the first node at least
// a given share of the limb's length away from the joint before, so that helper and twist joints
// are passed. Nothing where the chains are too short.
[[nodiscard]] std::optional<std::array<LimbNodes, 2>> leg_nodes(const SkeletonTree& tree,
                                                                const BranchPair& legs);
[[nodiscard]] std::optional<std::array<LimbNodes, 2>> arm_nodes(const SkeletonTree& tree,
                                                                const BranchPair& arms);

// The joints of the limb that begins at `upper`, likewise.
[[nodiscard]] std::optional<LimbNodes> limb_joints(const SkeletonTree& tree, int upper, bool arm);

// Why a body without names has no shape: what is missing, and what there is instead.
[[nodiscard]] Message missing_by_shape(const SkeletonTree& tree);

// The chains at `hub` where a limb is missing, for a message: "joint 'Hips' has 1 chain that goes
// down: 'LeftHip'".
[[nodiscard]] Message describe_branches(const SkeletonTree& tree, int hub, bool downwards);

}  // namespace shigusa
