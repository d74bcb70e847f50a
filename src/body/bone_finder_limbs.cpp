// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "bone_finder.hpp"

namespace shigusa {

// A limb as the file or a person tells it; false where they tell none, or no chain.
bool BoneFinder::take_given(std::size_t limb) {
  const auto& [upper, lower, end] = kLimbs[limb];
  if (!strictly_below(given_[lower], given_[upper]) ||
      !strictly_below(given_[end], given_[lower])) {
    if (!any_given_) return false;
    doubt("the file's own map has no whole {}: it was looked for by names", kLimbNames[limb]);
    return false;
  }
  for (const Bone bone : kLimbs[limb]) map_[bone] = given_[bone];
  return true;
}

// Takes the first chain with the right names; of an incomplete one what there is, for the
// message. False where a bone is missing.
bool BoneFinder::find_by_name(std::size_t limb) {
  using P = BonePart;
  const NameSide side = limb % 2 == 0 ? NameSide::left : NameSide::right;
  const bool leg = limb < 2;
  const auto called = [&](std::size_t k, std::initializer_list<P> of_leg,
                          std::initializer_list<P> of_arm) {
    const int asked = asked_[kLimbs[limb][k]];
    return asked >= 0 ? std::vector<int>{asked} : named(side, leg ? of_leg : of_arm);
  };
  const std::vector<int> uppers =
      called(0, {P::upper_leg, P::hip, P::leg}, {P::upper_arm, P::arm, P::shoulder});
  const std::vector<int> lowers = called(1, {P::lower_leg, P::leg}, {P::lower_arm});
  const std::vector<int> ends = called(2, {P::ankle, P::foot}, {P::hand});
  LimbNodes best{-1, -1, -1};
  for (const int upper : uppers) {
    // a hip at the very place of its parent only carries the leg (CMU's LHipJoint)
    if (name(upper).part == P::hip && at_parent(upper)) continue;
    const int lower = first_below(lowers, upper);
    const int end = lower < 0 ? -1 : first_below(ends, lower);
    if (best[0] < 0 || (best[1] < 0 && lower >= 0) || end >= 0) best = {upper, lower, end};
    if (end >= 0) break;
  }
  if (leg && best[1] >= 0 && best[2] < 0) best[2] = foot_at_tip(ends, best[1], limb);
  for (std::size_t k = 0; k < 3; ++k) map_[kLimbs[limb][k]] = best[k];
  return best[2] >= 0;
}

// A foot that hangs on a root, as a control, at the end of a shank without one (Quaternius), or
// -1.
int BoneFinder::foot_at_tip(const std::vector<int>& feet, int shank, std::size_t limb) {
  constexpr double kNear = 0.15;  // of the shank
  const int tip = tree_.farthest(shank);
  const double length = norm(tree_.at(tip) - tree_.at(shank));
  for (const int foot : feet) {
    if (tip == shank || norm(tree_.at(foot) - tree_.at(tip)) > kNear * length) continue;
    doubt("{} stands at the end of the {} and does not hang on it", tree_.described(foot),
          kLimbNames[limb]);
    return foot;
  }
  return -1;
}

// All limbs by the shape of the skeleton; false where it does not tell them.
bool BoneFinder::find_by_shape() {
  const std::optional<BodyShape> shape = find_body_shape(tree_);
  if (!shape) return false;
  const auto legs = leg_nodes(tree_, shape->legs);
  const auto arms = arm_nodes(tree_, shape->arms);
  if (!legs || !arms) return false;
  const Vec3d left = left_of_feet(*shape, *legs);
  const std::size_t left_leg = left_of(shape->legs, *legs, left);
  const Vec3d across = tree_.at((*legs)[left_leg][0]) - tree_.at((*legs)[1 - left_leg][0]);
  const std::size_t left_arm = left_of(shape->arms, *arms, across);
  for (std::size_t k = 0; k < 3; ++k) {
    map_[kLimbs[0][k]] = (*legs)[left_leg][k];
    map_[kLimbs[1][k]] = (*legs)[1 - left_leg][k];
    map_[kLimbs[2][k]] = (*arms)[left_arm][k];
    map_[kLimbs[3][k]] = (*arms)[1 - left_arm][k];
  }
  return true;
}

// The direction of the body's left by the way the feet point; a guess where they tell nothing.
Vec3d BoneFinder::left_of_feet(const BodyShape& shape, const std::array<LimbNodes, 2>& legs) {
  Vec3d ahead{};
  Vec3d up{};
  for (const LimbNodes& leg : legs) {
    ahead += tree_.foot_from(leg[2]);
    up += tree_.at(leg[0]) - tree_.at(leg[2]);
  }
  constexpr double kClearly = 0.02;
  const Vec3d left = cross(up, ahead);
  if (norm(left) > kClearly * dot(up, up)) return left;
  if (side_by_names(shape.legs.branch[0]) == side_by_names(shape.legs.branch[1])) {
    doubt("left and right are a guess: neither names nor feet tell; {} is taken as left",
          tree_.described(legs[0][0]));
  }
  return tree_.at(legs[0][0]) - tree_.at(legs[1][0]);
}

// Which of two limbs is the left one: by the names on it, else by the direction of left.
std::size_t BoneFinder::left_of(const BranchPair& pair, const std::array<LimbNodes, 2>& limbs,
                                const Vec3d& left) const {
  const int first = side_by_names(pair.branch[0]);
  const int second = side_by_names(pair.branch[1]);
  if (first != second) return first > second ? 0 : 1;
  return dot(tree_.at(limbs[0][0]) - tree_.at(limbs[1][0]), left) >= 0.0 ? 0 : 1;
}

// 1 where more names of a branch say left, -1 where more say right; what is asked for outweighs
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

// What there is instead of a limb, in terms of the file's own joints.
std::string BoneFinder::missing(std::size_t limb) const {
  for (std::size_t k = 1; k < 3; ++k) {
    const int above = map_[kLimbs[limb][k - 1]];
    if (above < 0 || map_[kLimbs[limb][k]] >= 0) continue;
    const std::vector<int> chain = tree_.chain(above, above);
    return fmt::format(
        "no {}: below {} {}", humanoid_bone_name(kLimbs[limb][k]), tree_.described(above),
        chain.empty() ? "nothing follows" : "comes only " + tree_.described(chain.front()));
  }
  const int from = hub(limb);
  if (from < 0) return missing_by_shape(tree_);
  return fmt::format("no {}: {}", kLimbNames[limb], describe_branches(tree_, from, limb < 2));
}

// The node where a missing limb should leave: where its fellow does, else the hips by name, else
// where another limb does; -1 where nothing tells.
int BoneFinder::hub(std::size_t missing_limb) const {
  int node = map_[kLimbs[missing_limb ^ 1][0]];
  if (node < 0) {
    const std::vector<int> hips = named(NameSide::none, {BonePart::hips, BonePart::hip});
    if (!hips.empty()) return hips.front();
  }
  for (std::size_t limb = 0; limb < kLimbs.size() && node < 0; ++limb) {
    node = map_[kLimbs[limb][0]];
  }
  if (node < 0) return -1;
  do {
    if (tree_.node(node).parent < 0) break;
    node = tree_.node(node).parent;
  } while (tree_.children(node).size() < 2);
  return node;
}

}  // namespace shigusa
