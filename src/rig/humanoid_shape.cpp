// SPDX-License-Identifier: MIT
#include "humanoid_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/say.hpp"

namespace shigusa {
namespace {

// Share of the figure's extent below which chains are fingers, faces and ornaments.
constexpr double kShortestLimb = 0.2;
// Largest difference of the two sides' segment lengths, as a share of their sum.
constexpr double kLimbAsymmetry = 0.3;
constexpr std::size_t kFewestSegments = 3;
// Limits on the search in figures of many branches; a person's limbs are among the longest.
constexpr std::size_t kBranchesTried = 6;
constexpr std::size_t kPairsTried = 64;

// Least distance of a joint beyond the one before, as a share of the limb's length: people have
// 0.38 to 0.42 for thigh, shank and upper arm, 0.33 for the forearm; half of those are twist
// joints.
constexpr double kSegmentShare = 0.27;
constexpr double kForearmShare = 0.22;
// Least distance of shoulders from the middle, as a share of the chain's length beyond its first
// node: shoulders have 0.23 or more, the inner ends of collar bones 0.07 or less.
constexpr double kShoulderShare = 0.1;

double branch_length(const SkeletonTree& tree, int node, int branch) {
  return norm(tree.at(branch) - tree.at(node)) + tree.reach(branch);
}

std::vector<double> segments(const SkeletonTree& tree, int node, const std::vector<int>& chain) {
  std::vector<double> lengths;
  for (const int i : chain) {
    lengths.push_back(norm(tree.at(i) - tree.at(node)));
    node = i;
  }
  return lengths;
}

bool similar(const SkeletonTree& tree, int node, int a, int b) {
  const std::vector<double> left = segments(tree, node, tree.chain(node, a));
  const std::vector<double> right = segments(tree, node, tree.chain(node, b));
  if (std::min(left.size(), right.size()) < kFewestSegments) return false;
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < std::max(left.size(), right.size()); ++i) {
    const double x = i < left.size() ? left[i] : 0.0;
    const double y = i < right.size() ? right[i] : 0.0;
    difference += abs(x - y);
    sum += x + y;
  }
  return difference <= kLimbAsymmetry * sum;
}

void add_pairs(const SkeletonTree& tree, int node, std::vector<BranchPair>& pairs) {
  std::vector<int> branches = tree.children(node);
  const auto length = [&](int branch) { return branch_length(tree, node, branch); };
  std::stable_sort(branches.begin(), branches.end(),
                   [&](int a, int b) { return length(a) > length(b); });
  branches.resize(std::min(branches.size(), kBranchesTried));
  for (std::size_t a = 0; a < branches.size(); ++a) {
    for (std::size_t b = a + 1; b < branches.size(); ++b) {
      const double shorter = length(branches[b]);
      if (shorter < kShortestLimb * tree.extent()) continue;
      if (!similar(tree, node, branches[a], branches[b])) continue;
      const auto [low, high] = std::minmax(branches[a], branches[b]);
      pairs.push_back({node, {low, high}, shorter});
    }
  }
}

bool independent(const SkeletonTree& tree, const BranchPair& legs, const BranchPair& arms) {
  if (legs.node == arms.node) {
    for (const int branch : arms.branch) {
      if (branch == legs.branch[0] || branch == legs.branch[1]) return false;
    }
    return true;
  }
  // a pelvis may be a branch beside the spine
  return !tree.below(legs.node, arms.node) && !tree.below(arms.node, legs.branch[0]) &&
         !tree.below(arms.node, legs.branch[1]);
}

// Longest branch of a node beside a pair and the branch towards `other`: a head, or -1.
int third_branch(const SkeletonTree& tree, const BranchPair& pair, const BranchPair& other) {
  int best = -1;
  double longest = 0.05 * tree.extent();
  for (const int child : tree.children(pair.node)) {
    const bool taken = child == pair.branch[0] || child == pair.branch[1] ||
                       tree.below(other.branch[0], child) || tree.below(other.branch[1], child);
    const double length = branch_length(tree, pair.node, child);
    if (taken || length <= longest) continue;
    best = child;
    longest = length;
  }
  return best;
}

// Assigns two pairs to legs and arms: the legs are away from the head.
BodyShape ordered(const SkeletonTree& tree, const BranchPair& upper, const BranchPair& lower) {
  if (upper.node != lower.node) {
    // the root is in the chest if the head leaves there
    const bool chest_root =
        third_branch(tree, upper, lower) >= 0 && third_branch(tree, lower, upper) < 0;
    return chest_root ? BodyShape{lower, upper} : BodyShape{upper, lower};
  }
  const int head = third_branch(tree, upper, lower);
  if (head < 0) {
    // without their first segments, where a trunk may be missing, legs are the longer limbs
    const auto limb = [&](const BranchPair& pair) {
      return pair.length - norm(tree.at(pair.branch[0]) - tree.at(pair.node));
    };
    return limb(upper) >= limb(lower) ? BodyShape{upper, lower} : BodyShape{lower, upper};
  }
  const Vec3d up = tree.at(tree.farthest(head)) - tree.at(upper.node);
  const auto height = [&](const BranchPair& pair) {
    return dot(up, tree.at(tree.farthest(pair.branch[0])) + tree.at(tree.farthest(pair.branch[1])));
  };
  return height(upper) < height(lower) ? BodyShape{upper, lower} : BodyShape{lower, upper};
}

std::vector<BranchPair> longest_pairs(const SkeletonTree& tree) {
  std::vector<BranchPair> pairs;
  for (int i = 0; i < tree.size(); ++i) add_pairs(tree, i, pairs);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const BranchPair& a, const BranchPair& b) { return a.length > b.length; });
  pairs.resize(std::min(pairs.size(), kPairsTried));
  return pairs;
}

// The chain's node `start` and the two joints beyond it.
std::optional<LimbNodes> joints(const SkeletonTree& tree, const std::vector<int>& chain,
                                std::size_t start, double second_share) {
  double length = 0.0;
  for (std::size_t i = start + 1; i < chain.size(); ++i) {
    length += norm(tree.at(chain[i]) - tree.at(chain[i - 1]));
  }
  LimbNodes nodes{chain[start], -1, -1};
  // a chain with at most three joints apart consists of the limb's joints
  constexpr double kLeast = 0.15;  // of the limb
  if (chain.size() == start + 3 && !tree.node(chain.back()).end_site) {
    const double upper = norm(tree.at(chain[start + 1]) - tree.at(chain[start]));
    if (upper >= kLeast * length && length - upper >= kLeast * length) {
      return LimbNodes{chain[start], chain[start + 1], chain[start + 2]};
    }
  }
  std::size_t found = 1;
  double beyond = 0.0;
  for (std::size_t i = start + 1; i < chain.size() && found < 3; ++i) {
    beyond += norm(tree.at(chain[i]) - tree.at(chain[i - 1]));
    if (beyond < (found == 1 ? kSegmentShare : second_share) * length) continue;
    if (tree.node(chain[i]).end_site) return std::nullopt;
    nodes[found++] = chain[i];
    beyond = 0.0;
  }
  if (found < 3) return std::nullopt;
  return nodes;
}

// Joints of a chain at the same relative positions as those of its counterpart.
std::optional<LimbNodes> joints_like(const SkeletonTree& tree, const LimbNodes& fellow,
                                     const std::vector<int>& chain, std::size_t start) {
  LimbNodes nodes{chain[start], -1, -1};
  std::size_t from = start;
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const double wanted = norm(tree.at(fellow[k]) - tree.at(fellow[k - 1]));
    const auto off = [&](std::size_t i) {
      return abs(norm(tree.at(chain[i]) - tree.at(chain[from])) - wanted);
    };
    std::size_t best = from + 1;
    for (std::size_t i = from + 1; i < chain.size(); ++i) {
      if (off(i) < off(best)) best = i;
    }
    if (best >= chain.size() || tree.node(chain[best]).end_site) return std::nullopt;
    nodes[k] = chain[best];
    from = best;
  }
  return nodes;
}

}  // namespace

std::optional<BodyShape> find_body_shape(const SkeletonTree& tree, const MayBeLimbs& may_be) {
  const std::vector<BranchPair> pairs = longest_pairs(tree);
  std::vector<bool> legs;
  std::vector<bool> arms;
  for (const BranchPair& pair : pairs) {
    legs.push_back(may_be(pair, true));
    arms.push_back(may_be(pair, false));
  }
  std::optional<BodyShape> best;
  double longest = 0.0;
  for (std::size_t u = 0; u < pairs.size(); ++u) {
    for (std::size_t l = 0; l < pairs.size(); ++l) {
      const double length = pairs[u].length + pairs[l].length;
      if (u == l || length <= longest || !independent(tree, pairs[u], pairs[l])) continue;
      const bool as_told = legs[u] && arms[l];
      const bool turned = legs[l] && arms[u];
      if (!as_told && !turned) continue;
      longest = length;
      best = as_told && turned ? ordered(tree, pairs[u], pairs[l])
             : as_told         ? BodyShape{pairs[u], pairs[l]}
                               : BodyShape{pairs[l], pairs[u]};
    }
  }
  return best;
}

std::optional<BranchPair> longest_pair(const SkeletonTree& tree, const BranchPair& other,
                                       const std::function<bool(const BranchPair&)>& may_be) {
  for (const BranchPair& pair : longest_pairs(tree)) {
    const bool apart = independent(tree, other, pair) || independent(tree, pair, other);
    if (apart && may_be(pair)) return pair;
  }
  return std::nullopt;
}

std::optional<std::array<LimbNodes, 2>> leg_nodes(const SkeletonTree& tree,
                                                  const BranchPair& legs) {
  std::array<LimbNodes, 2> result;
  for (std::size_t s = 0; s < 2; ++s) {
    const std::vector<int> chain = tree.chain(legs.node, legs.branch[s]);
    const auto nodes = chain.empty() ? std::nullopt : joints(tree, chain, 0, kSegmentShare);
    if (!nodes) return std::nullopt;
    result[s] = *nodes;
  }
  return result;
}

std::optional<std::array<LimbNodes, 2>> arm_nodes(const SkeletonTree& tree,
                                                  const BranchPair& arms) {
  const std::vector<int> first = tree.chain(arms.node, arms.branch[0]);
  const std::vector<int> second = tree.chain(arms.node, arms.branch[1]);
  const std::size_t count = std::min(first.size(), second.size());
  if (count == 0) return std::nullopt;
  const double least =
      kShoulderShare * (arms.length - norm(tree.at(first[0]) - tree.at(arms.node)));
  const auto too_near = [&](std::size_t i) {
    return 0.5 * norm(tree.at(first[i]) - tree.at(second[i])) < least;
  };
  std::size_t shoulder = 0;
  while (shoulder < count && too_near(shoulder)) ++shoulder;
  if (shoulder == count) return std::nullopt;
  auto a = joints(tree, first, shoulder, kForearmShare);
  auto b = joints(tree, second, shoulder, kForearmShare);
  // a hand may have fingers and its counterpart none: the shorter chain determines both
  if (a && first.size() < second.size()) b = joints_like(tree, *a, second, shoulder);
  if (b && second.size() < first.size()) a = joints_like(tree, *b, first, shoulder);
  if (!a || !b) return std::nullopt;
  return std::array<LimbNodes, 2>{*a, *b};
}

std::optional<LimbNodes> limb_joints(const SkeletonTree& tree, int upper, bool arm) {
  std::vector<int> chain = tree.chain(upper, upper);
  chain.insert(chain.begin(), upper);
  return joints(tree, chain, 0, arm ? kForearmShare : kSegmentShare);
}

Message missing_by_shape(const SkeletonTree& tree) {
  const std::vector<BranchPair> pairs = longest_pairs(tree);
  if (!pairs.empty()) {
    const auto& [first, second] = pairs.front().branch;
    return say("no_two_pairs", tree.described(first), tree.described(second));
  }
  const auto long_branches = [&](int node) {
    int count = 0;
    for (const int child : tree.children(node)) {
      if (branch_length(tree, node, child) >= kShortestLimb * tree.extent()) ++count;
    }
    return count;
  };
  int hub = 0;
  for (int i = tree.size(); i-- > 0;) {
    if (long_branches(i) > 1) hub = i;
  }
  return say("no_limb", "left leg", describe_branches(tree, hub, true));
}

Message describe_branches(const SkeletonTree& tree, int hub, bool downwards) {
  const std::vector<int>& children = tree.children(hub);
  const auto tip = [&](int branch) { return tree.at(tree.farthest(branch)) - tree.at(hub); };
  int spine = -1;  // the branch of the most joints
  int most = 0;
  for (const int child : children) {
    int joints_below = 0;
    for (int i = child; i < tree.size(); ++i) joints_below += tree.below(i, child) ? 1 : 0;
    if (joints_below > most) spine = child;
    most = std::max(most, joints_below);
  }
  int count = 0;
  std::string list;
  for (const int child : children) {
    if (downwards && (child == spine || dot(tip(child), tip(spine)) >= 0.0)) continue;
    if (++count <= 4) list += (list.empty() ? "" : ", ") + tree.described(child);
  }
  if (count > 4) list += ", …";
  const std::string at = tree.described(hub);
  if (count == 0) return downwards ? say("no_chains_down", at) : say("no_chains", at);
  if (count == 1) return downwards ? say("one_chain_down", at, list) : say("one_chain", at, list);
  return downwards ? say("chains_down", at, count, list) : say("chains", at, count, list);
}

}  // namespace shigusa
