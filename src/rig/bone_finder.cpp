// SPDX-License-Identifier: MIT
#include "bone_finder.hpp"

#include <algorithm>

#include "core/check.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "facing.hpp"
#include "other_build.hpp"
#include "rig/find_humanoid.hpp"

namespace shigusa {

BoneFinder::BoneFinder(const SkeletonTree& tree, const HumanoidMap& given, const HumanoidMap& asked)
    : tree_(tree), given_(given), asked_(asked) {
  for (int i = 0; i < tree.size(); ++i) {
    names_.push_back(tree.node(i).end_site ? BoneName{} : read_bone_name(tree.node(i).name));
  }
  leave_to_deforming_bones();
  for (const Bone bone : kHumanoidBones) {
    SHG_CHECK(given[bone] < tree.size() && asked[bone] < tree.size(),
              "a given node of the skeleton");
    any_given_ = any_given_ || given[bone] >= 0;
    if (asked[bone] < 0) continue;
    given_[bone] = asked[bone];
    // regardless of its own name
    const std::string_view word = humanoid_bone_name(bone);
    const NameSide side = word.starts_with("left_")    ? NameSide::left
                          : word.starts_with("right_") ? NameSide::right
                                                       : NameSide::none;
    names_[index(asked[bone])] = {BonePart::none, side};
  }
}

Result<HumanoidMap> BoneFinder::find() {
  if (tree_.size() == 0) return fail(ErrorCode::invalid_argument, say("no_nodes"));
  if (tree_.extent() <= 0.0) {
    return fail(ErrorCode::invalid_argument,
                say("no_skeleton",
                    tree_.size() == 1 ? say("one_node") : say("nodes_at_one_point", tree_.size())));
  }
  SHG_TRY(find_limbs());
  if (!find_hips()) {
    return fail(ErrorCode::invalid_argument, say("several_roots"));
  }
  find_trunk_branch();
  find_neck_and_head();
  find_spine();
  find_shoulder(Bone::left_shoulder, Bone::left_upper_arm);
  find_shoulder(Bone::right_shoulder, Bone::right_upper_arm);
  find_toes(Side::left, Bone::left_toes);
  find_toes(Side::right, Bone::right_toes);
  SHG_TRY(check_asked());
  SHG_TRY(check_build());
  map_.mirrored = is_mirrored(tree_, map_);
  if (map_.mirrored) doubt("feet_backwards");
  return std::move(map_);
}

// Finds each limb by the file's own map or its names, and the remaining ones by shape.
Result<void> BoneFinder::find_limbs() {
  std::array<bool, 4> found{};
  for (std::size_t limb = kLimbs.size(); limb-- > 0;) {
    found[limb] = take_given(limb) || find_by_name(limb);
  }
  const auto gap =
      static_cast<std::size_t>(std::find(found.begin(), found.end(), false) - found.begin());
  if (gap == found.size()) return {};
  const bool none = std::count(found.begin(), found.end(), true) == 0;
  if (!find_by_shape(found)) return fail(ErrorCode::invalid_argument, missing(gap));
  doubt("found_by_shape", kLimbNames[gap], none ? say("all_limbs") : say("the_rest"));
  return {};
}

// Restricts names to bones prefixed DEF-, as a complete Rigify rig has several copies of each limb
// and its mesh follows those.
void BoneFinder::leave_to_deforming_bones() {
  constexpr int kFewest = 8;
  int deforming = 0;
  for (int i = 0; i < tree_.size(); ++i) {
    if (name(i).side != NameSide::none && name(i).part != BonePart::none && deforms(i)) {
      ++deforming;
    }
  }
  if (deforming < kFewest) return;
  deforming_only_ = true;
  for (int i = 0; i < tree_.size(); ++i) {
    if (name(i).side != NameSide::none && !deforms(i)) {
      names_[index(i)].part = BonePart::none;
    }
  }
}

bool BoneFinder::deforms(int i) const {
  return tree_.node(i).name.find("DEF-") != std::string::npos;
}

// Nodes of a side with these parts, ordered by part, then from the root.
std::vector<int> BoneFinder::named(NameSide side, const std::vector<BonePart>& parts) const {
  std::vector<int> nodes;
  for (const BonePart part : parts) {
    for (int i = 0; i < tree_.size(); ++i) {
      if (name(i).side == side && name(i).part == part) nodes.push_back(i);
    }
  }
  return nodes;
}

// First of the nodes strictly below `ancestor`, or -1: nodes with children come before those
// without (Unreal's wrist_inner_l beside hand_l), and within a chain the uppermost is first
// (ankle_bck_l below foot_l).
int BoneFinder::first_below(const std::vector<int>& nodes, int ancestor) const {
  int first = -1;
  for (const int i : nodes) {
    if (!strictly_below(i, ancestor)) continue;
    if (first < 0 || (tree_.children(first).empty() && !tree_.children(i).empty())) first = i;
  }
  for (const int i : nodes) {
    if (strictly_below(first, i) && strictly_below(i, ancestor)) first = i;
  }
  return first;
}

// Whether a node neither belongs to a limb nor is an ancestor of one; a foot or a hand may be
// attached like that, as a control.
bool BoneFinder::is_beside_limbs(int i) const {
  return std::none_of(kLimbs.begin(), kLimbs.end(), [&](const auto& limb) {
    const int upper = map_[limb[0]];
    return tree_.below(i, upper) || tree_.below(upper, i);
  });
}

bool BoneFinder::at_parent(int i) const {
  const int parent = tree_.node(i).parent;
  return parent >= 0 && !tree_.apart(i, parent);
}

bool BoneFinder::strictly_below(int i, int ancestor) const {
  return i >= 0 && ancestor >= 0 && i != ancestor && tree_.below(i, ancestor);
}

// Fails if the skeleton is another creature's, unless its file or the user assigned its bones.
Result<void> BoneFinder::check_build() const {
  const bool asked =
      std::any_of(asked_.node.begin(), asked_.node.end(), [](int node) { return node >= 0; });
  if (any_given_ || asked) return {};
  const bool by_names =
      std::none_of(map_.doubts.begin(), map_.doubts.end(),
                   [](const Message& message) { return message.key == "found_by_shape"; });
  const Message why = unlike_a_persons_build(tree_, map_, by_names);
  if (why.empty()) return {};
  return fail(ErrorCode::invalid_argument, say("no_person", why));
}

// Fails if a bone is not the node that the user assigned.
Result<void> BoneFinder::check_asked() const {
  const auto refuse = [this](Bone bone) {
    const int found = map_[bone];
    const std::string node = tree_.described(asked_[bone]);
    const std::string_view name = humanoid_bone_name(bone);
    return fail(ErrorCode::invalid_argument,
                found < 0 || found == asked_[bone]
                    ? say("cannot_be_bone", node, name)
                    : say("cannot_be_bone_found", node, name, tree_.described(found)));
  };
  for (const Bone bone : kHumanoidBones) {
    if (asked_[bone] >= 0 && map_[bone] != asked_[bone]) return refuse(bone);
  }
  for (const auto& limb : kLimbs) {
    const auto asks = [&](Bone bone) { return asked_[bone] >= 0; };
    if (std::none_of(limb.begin(), limb.end(), asks)) continue;
    for (std::size_t k = 1; k < limb.size(); ++k) {
      const int above = map_[limb[k - 1]];
      if (strictly_below(map_[limb[k]], above)) continue;
      if (k == 2 && is_beside_limbs(map_[limb[k]])) continue;
      return refuse(asked_[limb[k]] >= 0 ? limb[k] : limb[k - 1]);
    }
  }
  return {};
}

std::string_view humanoid_bone_name(HumanoidBone bone) {
  constexpr std::array<std::string_view, kHumanoidBoneCount> kNames{"hips",
                                                                    "neck",
                                                                    "head",
                                                                    "left_upper_leg",
                                                                    "left_lower_leg",
                                                                    "left_foot",
                                                                    "left_toes",
                                                                    "right_upper_leg",
                                                                    "right_lower_leg",
                                                                    "right_foot",
                                                                    "right_toes",
                                                                    "left_upper_arm",
                                                                    "left_lower_arm",
                                                                    "left_hand",
                                                                    "right_upper_arm",
                                                                    "right_lower_arm",
                                                                    "right_hand",
                                                                    "spine",
                                                                    "chest",
                                                                    "upper_chest",
                                                                    "left_shoulder",
                                                                    "right_shoulder"};
  return kNames[static_cast<std::size_t>(bone)];
}

Result<HumanoidMap> find_humanoid(const Skeleton& skeleton, const std::vector<Transformd>& world,
                                  const HumanoidMap& given, const HumanoidMap& asked,
                                  std::span<const SkinVertex> skin) {
  const SkeletonTree tree(skeleton, world, skin);
  return BoneFinder(tree, given, asked).find();
}

}  // namespace shigusa
