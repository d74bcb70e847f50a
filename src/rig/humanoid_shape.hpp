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

// Two chains of similar shape that leave one node.
struct BranchPair {
  int node = -1;
  std::array<int, 2> branch{};  // the first node of each, children of `node`
  double length = 0.0;          // length of the shorter one, from `node` to its tip
};

// Limbs of a body without names: two legs and, above them, two arms.
struct BodyShape {
  BranchPair legs;
  BranchPair arms;
};

// Thigh, shank and foot, or upper arm, forearm and hand.
using LimbNodes = std::array<int, 3>;

// Whether a pair may be the legs (true) or the arms.
using MayBeLimbs = std::function<bool(const BranchPair&, bool legs)>;

// The two pairs of limbs with the longest chains, with the arms on another branch than the legs:
// below the node of the legs, at it, or above it (if the root is in the chest).
[[nodiscard]] std::optional<BodyShape> find_body_shape(const SkeletonTree& tree,
                                                       const MayBeLimbs& may_be);

// The pair with the longest chains on branches other than `other`.
[[nodiscard]] std::optional<BranchPair> longest_pair(
    const SkeletonTree& tree, const BranchPair& other,
    const std::function<bool(const BranchPair&)>& may_be);

// Joints of a pair of limbs, by human proportions: a joint is the first node at least a given share
// of the limb's length beyond the previous joint, which skips helper and twist joints. Empty if the
// chains are too short.
[[nodiscard]] std::optional<std::array<LimbNodes, 2>> leg_nodes(const SkeletonTree& tree,
                                                                const BranchPair& legs);
[[nodiscard]] std::optional<std::array<LimbNodes, 2>> arm_nodes(const SkeletonTree& tree,
                                                                const BranchPair& arms);

// Joints of the limb that begins at `upper`, found in the same way.
[[nodiscard]] std::optional<LimbNodes> limb_joints(const SkeletonTree& tree, int upper, bool arm);

// Reason why a body without names has no valid shape: the missing part, and the chains found.
[[nodiscard]] Message missing_by_shape(const SkeletonTree& tree);

// Description of the chains at `hub` where a limb is missing, for a message: "joint 'Hips' has 1
// chain that goes down: 'LeftHip'".
[[nodiscard]] Message describe_branches(const SkeletonTree& tree, int hub, bool downwards);

}  // namespace shigusa
