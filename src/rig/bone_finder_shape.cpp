// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "bone_finder.hpp"
#include "core/say.hpp"
#include "facing.hpp"

namespace shigusa {

// Finds the limbs without usable names by the shape of the skeleton; false if that fails.
bool BoneFinder::find_by_shape(const std::array<bool, 4>& found) {
  const bool all_legs = found[0] && found[1];
  const bool all_arms = found[2] && found[3];
  const std::optional<BodyShape> shape = shape_beside(found);
  if (!shape) return false;
  const auto legs = leg_nodes(tree_, shape->legs);
  const auto arms = arm_nodes(tree_, shape->arms);
  if ((!legs && !all_legs) || (!arms && !all_arms)) return false;
  const auto take = [&](std::size_t limb, const LimbNodes& nodes) {
    for (std::size_t k = 0; k < 3 && !found[limb]; ++k) {
      const Bone bone = kLimbs[limb][k];
      map_[bone] = asked_[bone] >= 0 ? asked_[bone] : nodes[k];
    }
  };
  if (!all_legs) {
    const std::size_t left = left_of(shape->legs, *legs, left_of_feet(*shape, *legs));
    take(0, (*legs)[left]);
    take(1, (*legs)[1 - left]);
  }
  if (!all_arms) {
    const Vec3d across = at(Bone::left_upper_leg) - at(Bone::right_upper_leg);
    const std::size_t left = left_of(shape->arms, *arms, across);
    take(2, (*arms)[left]);
    take(3, (*arms)[1 - left]);
  }
  return true;
}

// Branches of legs and arms, respecting pairs found by name.
std::optional<BodyShape> BoneFinder::shape_beside(const std::array<bool, 4>& found) const {
  const auto may_be = [&](const BranchPair& pair, bool legs) {
    return may_be_limbs(pair, legs, found);
  };
  const bool all_legs = found[0] && found[1];
  if (all_legs == (found[2] && found[3])) return find_body_shape(tree_, may_be);
  const BranchPair named_pair = branches_of(all_legs ? 0 : 2);
  if (named_pair.node < 0) return std::nullopt;
  const std::optional<BranchPair> other = longest_pair(
      tree_, named_pair, [&](const BranchPair& pair) { return may_be(pair, !all_legs); });
  if (!other) return std::nullopt;
  return all_legs ? BodyShape{named_pair, *other} : BodyShape{*other, named_pair};
}

// Branches of a limb that was found and its right counterpart; empty if one is an ancestor of the
// other.
BranchPair BoneFinder::branches_of(std::size_t left_limb) const {
  const int left = map_[kLimbs[left_limb][0]];
  const int right = map_[kLimbs[left_limb + 1][0]];
  const auto branch = [&](int node, int hub) {
    while (node >= 0 && tree_.node(node).parent != hub) node = tree_.node(node).parent;
    return node;
  };
  const int hub = tree_.common_ancestor(left, right);
  if (hub == left || hub == right) return {};
  return {hub, {branch(left, hub), branch(right, hub)}, 0.0};
}

// Whether two branches may be the legs, or the arms: those found by name are; otherwise no joint of
// a leg may be named as one of an arm, nor the reverse, and none as an ornament.
bool BoneFinder::may_be_limbs(const BranchPair& pair, bool legs,
                              const std::array<bool, 4>& found) const {
  using P = BonePart;
  for (const std::size_t limb : {legs ? 0u : 2u, legs ? 1u : 3u}) {
    if (!found[limb]) continue;
    const int upper = map_[kLimbs[limb][0]];
    if (!tree_.below(upper, pair.branch[0]) && !tree_.below(upper, pair.branch[1])) return false;
  }
  for (const int branch : pair.branch) {
    if (name(branch).part == P::ornament) return false;
    for (int i = branch; i < tree_.size(); ++i) {
      if (!tree_.below(i, branch) || name(i).side == NameSide::none) continue;
      const P part = name(i).part;
      const bool of_leg = part == P::hip || part == P::upper_leg || part == P::leg ||
                          part == P::lower_leg || part == P::ankle || part == P::foot ||
                          part == P::toes;
      const bool of_arm = part == P::collar || part == P::shoulder || part == P::upper_arm ||
                          part == P::arm || part == P::lower_arm || part == P::hand ||
                          part == P::palm;
      if (legs ? of_arm : of_leg) return false;
    }
  }
  return true;
}

// Direction of the body's left from the feet's direction; a guess if they are inconclusive.
Vec3d BoneFinder::left_of_feet(const BodyShape& shape, const std::array<LimbNodes, 2>& legs) {
  Vec3d ahead{};
  Vec3d up{};
  for (const LimbNodes& leg : legs) {
    ahead += foot_from(tree_, leg[1], leg[2]);
    up += tree_.at(leg[0]) - tree_.at(leg[2]);
  }
  constexpr double kClearly = 0.02;
  const Vec3d left = cross(up, ahead);
  if (norm(left) > kClearly * dot(up, up)) return left;
  if (side_by_names(shape.legs.branch[0]) == side_by_names(shape.legs.branch[1])) {
    doubt("sides_guessed", tree_.described(legs[0][0]));
  }
  return tree_.at(legs[0][0]) - tree_.at(legs[1][0]);
}

// Index of the left one of two limbs: by their names, else by the direction of left.
std::size_t BoneFinder::left_of(const BranchPair& pair, const std::array<LimbNodes, 2>& limbs,
                                const Vec3d& left) const {
  const int first = side_by_names(pair.branch[0]);
  const int second = side_by_names(pair.branch[1]);
  if (first != second) return first > second ? 0 : 1;
  return dot(tree_.at(limbs[0][0]) - tree_.at(limbs[1][0]), left) >= 0.0 ? 0 : 1;
}

// 1 if more names of a branch state left, -1 if more state right; the user's assignment outweighs
// all names.
int BoneFinder::side_by_names(int branch) const {
  int balance = 0;
  for (int i = branch; i < tree_.size(); ++i) {
    if (!tree_.below(i, branch)) continue;
    const bool asked = std::find(asked_.node.begin(), asked_.node.end(), i) != asked_.node.end();
    const int weight = asked ? tree_.size() : 1;
    if (name(i).side == NameSide::left) balance += weight;
    if (name(i).side == NameSide::right) balance -= weight;
  }
  return balance > 0 ? 1 : balance < 0 ? -1 : 0;
}

}  // namespace shigusa
