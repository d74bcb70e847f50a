// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <shigusa/body/anthropometry.hpp>
#include <shigusa/body/humanoid_map.hpp>
#include <shigusa/core/check.hpp>

#include "humanoid_names.hpp"
#include "humanoid_shape.hpp"
#include "skeleton_tree.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

// The bones of each limb from the trunk outwards; even places are left, the first two are legs.
constexpr std::array<std::array<Bone, 3>, 4> kLimbs{{
    {Bone::left_upper_leg, Bone::left_lower_leg, Bone::left_foot},
    {Bone::right_upper_leg, Bone::right_lower_leg, Bone::right_foot},
    {Bone::left_upper_arm, Bone::left_lower_arm, Bone::left_hand},
    {Bone::right_upper_arm, Bone::right_lower_arm, Bone::right_hand},
}};
constexpr std::array<std::string_view, 4> kLimbNames{"left leg", "right leg", "left arm",
                                                     "right arm"};

// A spine's lowest joint stands at least this share of the way to the neck above the hip joints.
constexpr double kLeastSpine = 0.03;

class BoneFinder {
 public:
  BoneFinder(const SkeletonTree& tree, const HumanoidMap& given, const HumanoidMap& asked)
      : tree_(tree), given_(given), asked_(asked) {
    for (int i = 0; i < tree.size(); ++i) {
      names_.push_back(tree.node(i).end_site ? BoneName{} : read_bone_name(tree.node(i).name));
    }
    for (std::size_t b = 0; b < given.node.size(); ++b) {
      SHG_CHECK(given.node[b] < tree.size() && asked.node[b] < tree.size(),
                "a given node of the skeleton");
      any_given_ = any_given_ || given.node[b] >= 0;
      if (asked.node[b] < 0) continue;
      given_.node[b] = asked.node[b];
      // whatever its own name says
      const std::string_view bone = humanoid_bone_name(static_cast<Bone>(b));
      const NameSide side = bone.starts_with("left_")    ? NameSide::left
                            : bone.starts_with("right_") ? NameSide::right
                                                         : NameSide::none;
      names_[static_cast<std::size_t>(asked.node[b])] = {BonePart::none, side};
    }
  }

  Result<HumanoidMap> find() {
    if (tree_.size() == 0) return fail(ErrorCode::invalid_argument, "no body: there are no nodes");
    if (tree_.extent() <= 0.0) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("no body: all {} nodes stand at one point", tree_.size()));
    }
    std::size_t gap = kLimbs.size();
    for (std::size_t limb = kLimbs.size(); limb-- > 0;) {
      if (!take_given(limb) && !find_by_name(limb)) gap = limb;
    }
    if (gap < kLimbs.size()) {
      if (!find_by_shape()) return fail(ErrorCode::invalid_argument, missing(gap));
      doubt("the names do not tell the {}: all limbs were found by the skeleton's shape",
            kLimbNames[gap]);
      for (const auto& limb : kLimbs) {
        for (const Bone bone : limb) map_[bone] = asked_[bone] >= 0 ? asked_[bone] : map_[bone];
      }
    }
    if (!find_hips()) {
      return fail(ErrorCode::invalid_argument, "no hips: the limbs hang on several roots");
    }
    find_neck_and_head();
    find_spine();
    find_shoulder(Bone::left_shoulder, Bone::left_upper_arm);
    find_shoulder(Bone::right_shoulder, Bone::right_upper_arm);
    find_toes(NameSide::left, Bone::left_foot, Bone::left_toes);
    find_toes(NameSide::right, Bone::right_foot, Bone::right_toes);
    if (const auto obeyed = check_asked(); !obeyed) return tl::unexpected(obeyed.error());
    if (feet_point_backwards(tree_, map_)) {
      doubt(
          "the feet point backwards, seen from the left and right of the names: the file is "
          "mirrored, or its left and right are exchanged");
    }
    return std::move(map_);
  }

 private:
  template <class... Args>
  void doubt(fmt::format_string<Args...> format, Args&&... args) {
    map_.doubts.push_back(fmt::format(format, std::forward<Args>(args)...));
  }

  [[nodiscard]] const BoneName& name(int i) const { return names_[static_cast<std::size_t>(i)]; }

  // Nodes of that side and these parts; those of an earlier part first, then the higher ones.
  [[nodiscard]] std::vector<int> named(NameSide side, std::initializer_list<BonePart> parts) const {
    std::vector<int> nodes;
    for (const BonePart part : parts) {
      for (int i = 0; i < tree_.size(); ++i) {
        if (name(i).side == side && name(i).part == part) nodes.push_back(i);
      }
    }
    return nodes;
  }

  // The first of the nodes below `ancestor`, itself not included, or -1.
  [[nodiscard]] int first_below(const std::vector<int>& nodes, int ancestor) const {
    for (const int i : nodes) {
      if (i != ancestor && tree_.below(i, ancestor)) return i;
    }
    return -1;
  }

  [[nodiscard]] bool at_parent(int i) const {
    const int parent = tree_.node(i).parent;
    return parent >= 0 && !tree_.apart(i, parent);
  }

  [[nodiscard]] bool strictly_below(int i, int ancestor) const {
    return i >= 0 && ancestor >= 0 && i != ancestor && tree_.below(i, ancestor);
  }

  // What a person asked for stands, or is refused.
  [[nodiscard]] Result<void> check_asked() const {
    const auto refuse = [this](Bone bone) {
      const int found = map_[bone];
      return fail(
          ErrorCode::invalid_argument,
          fmt::format(
              "{} cannot be {}: it does not hang where that bone does{}",
              tree_.described(asked_[bone]), humanoid_bone_name(bone),
              found < 0 || found == asked_[bone] ? "" : "; found is " + tree_.described(found)));
    };
    for (int b = 0; b < kHumanoidBoneCount; ++b) {
      const auto bone = static_cast<Bone>(b);
      if (asked_[bone] >= 0 && map_[bone] != asked_[bone]) return refuse(bone);
    }
    for (const auto& limb : kLimbs) {
      for (std::size_t k = 1; k < limb.size(); ++k) {
        if (strictly_below(map_[limb[k]], map_[limb[k - 1]])) continue;
        return refuse(asked_[limb[k]] >= 0 ? limb[k] : limb[k - 1]);
      }
    }
    return {};
  }

  // A limb as the file or a person tells it; false where they tell none, or no chain.
  bool take_given(std::size_t limb) {
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
  bool find_by_name(std::size_t limb) {
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
    for (std::size_t k = 0; k < 3; ++k) map_[kLimbs[limb][k]] = best[k];
    return best[2] >= 0;
  }

  // All limbs by the shape of the skeleton; false where it does not tell them.
  bool find_by_shape() {
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
  Vec3d left_of_feet(const BodyShape& shape, const std::array<LimbNodes, 2>& legs) {
    Vec3d ahead{};
    Vec3d up{};
    for (const LimbNodes& leg : legs) {
      ahead += tree_.at(tree_.farthest(leg[2])) - tree_.at(leg[2]);
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
  [[nodiscard]] std::size_t left_of(const BranchPair& pair, const std::array<LimbNodes, 2>& limbs,
                                    const Vec3d& left) const {
    const int first = side_by_names(pair.branch[0]);
    const int second = side_by_names(pair.branch[1]);
    if (first != second) return first > second ? 0 : 1;
    return dot(tree_.at(limbs[0][0]) - tree_.at(limbs[1][0]), left) >= 0.0 ? 0 : 1;
  }

  // 1 where more names of a branch say left, -1 where more say right; what is asked for outweighs
  // all names.
  [[nodiscard]] int side_by_names(int branch) const {
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
  [[nodiscard]] std::string missing(std::size_t limb) const {
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
  [[nodiscard]] int hub(std::size_t missing_limb) const {
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

  bool find_hips() {
    const auto meet = [&](Bone a, Bone b) { return tree_.common_ancestor(map_[a], map_[b]); };
    const int legs = meet(Bone::left_upper_leg, Bone::right_upper_leg);
    chest_ = meet(Bone::left_upper_arm, Bone::right_upper_arm);
    const int all = legs < 0 || chest_ < 0 ? -1 : tree_.common_ancestor(legs, chest_);
    if (all < 0) return false;
    // a root in the chest: the legs hang together below it
    const int lowest = all == chest_ ? legs : all;
    map_[Bone::hips] = lowest;
    const int given = given_[Bone::hips];
    if (given >= 0 && tree_.below(lowest, given)) {
      map_[Bone::hips] = given;
      return true;
    }
    if (any_given_) doubt("the file's own map has no hips above the legs: they were looked for");
    for (int i = 0; i <= lowest; ++i) {
      const bool named_hips = name(i).part == BonePart::hips || name(i).part == BonePart::hip;
      if (named_hips && name(i).side == NameSide::none && tree_.below(lowest, i)) {
        map_[Bone::hips] = i;
      }
    }
    return true;
  }

  void find_neck_and_head() {
    int& neck = map_[Bone::neck];
    int& head = map_[Bone::head];
    const std::vector<int> necks = named(NameSide::none, {BonePart::neck});
    const bool neck_given = strictly_below(given_[Bone::neck], chest_);
    neck = neck_given ? given_[Bone::neck] : first_below(necks, chest_);
    // one at the place of the chest is a helper if another neck joint follows
    const int upper_neck = neck < 0 || neck_given ? -1 : first_below(necks, neck);
    if (upper_neck >= 0 && at_parent(neck) && tree_.apart(upper_neck, neck)) neck = upper_neck;
    const int trunk_end = neck >= 0 ? neck : chest_;
    head = strictly_below(given_[Bone::head], trunk_end)
               ? given_[Bone::head]
               : first_below(named(NameSide::none, {BonePart::head}), trunk_end);
    if (head < 0) head = head_by_shape();
    if (neck < 0 && head >= 0) neck = neck_by_shape(head);
    if (neck < 0) doubt("no neck joint: none stands between the arms and the head");
    if (head < 0) doubt("no head joint: no chain leaves the trunk between the arms");
  }

  // The node where the way up from the neck ends or forks; without a neck, of the longest branch
  // beside the limbs.
  [[nodiscard]] int head_by_shape() const {
    int start = map_[Bone::neck];
    double longest = 0.02 * tree_.extent();
    for (const int child : tree_.children(chest_)) {
      if (map_[Bone::neck] >= 0) break;
      const double length = norm(tree_.at(child) - tree_.at(chest_)) + tree_.reach(child);
      bool limb = false;
      for (const auto& bones : kLimbs) limb = limb || tree_.below(map_[bones[0]], child);
      if (limb || length <= longest) continue;
      start = child;
      longest = length;
    }
    if (start < 0) return -1;
    int head = -1;
    for (const int i : tree_.chain(tree_.node(start).parent, start)) {
      if (tree_.node(i).end_site) break;
      if (i != map_[Bone::neck]) head = i;
      if (head >= 0 && tree_.children(i).size() > 1) break;
    }
    return head;
  }

  // The lowest joint between chest and head that stands apart from both.
  [[nodiscard]] int neck_by_shape(int head) const {
    int neck = -1;
    for (int i = tree_.node(head).parent; i >= 0 && i != chest_; i = tree_.node(i).parent) {
      if (tree_.apart(i, chest_) && tree_.apart(i, head)) neck = i;
    }
    return neck;
  }

  // The joints on the way down from `end` to `top`, that not included, that stand apart from it and
  // from one another, from above.
  [[nodiscard]] std::vector<int> joints_between(int top, int end) const {
    std::vector<int> joints;
    for (int i = end; i >= 0 && i != top; i = tree_.node(i).parent) {
      if (!tree_.apart(i, top)) continue;
      // of several at one point the bone is the first
      if (!joints.empty() && !tree_.apart(i, joints.front())) joints.erase(joints.begin());
      joints.insert(joints.begin(), i);
    }
    return joints;
  }

  void find_spine() {
    constexpr std::array kSpine{Bone::spine, Bone::chest, Bone::upper_chest};
    const int hips = map_[Bone::hips];
    if (chest_ == hips || !tree_.below(chest_, hips)) return;
    std::vector<int> joints = joints_between(hips, chest_);
    if (take_given_spine(joints)) return;
    const Vec3d from = (at(Bone::left_upper_leg) + at(Bone::right_upper_leg)) * 0.5;
    const Vec3d to = map_[Bone::neck] >= 0
                         ? at(Bone::neck)
                         : (at(Bone::left_upper_arm) + at(Bone::right_upper_arm)) * 0.5;
    const Vec3d way = to - from;
    const auto share = [&](int i) { return dot(tree_.at(i) - from, way) / dot(way, way); };
    // hips at the place of the lowest joint are that joint
    std::erase_if(joints, [&](int i) { return !(share(i) > kLeastSpine) || share(i) >= 1.0; });
    while (joints.size() > kSpine.size()) {
      const auto off = [&](int i) {
        double nearest = 1.0;
        for (const double wanted : kSpineShares) nearest = min(nearest, abs(share(i) - wanted));
        return nearest;
      };
      joints.erase(std::max_element(joints.begin(), joints.end(),
                                    [&](int a, int b) { return off(a) < off(b); }));
    }
    for (std::size_t j = 0; j < joints.size(); ++j) map_[kSpine[j]] = joints[j];
  }

  // The file's own spine, where it tells one and it lies on the way; bones that it leaves out are
  // left out.
  bool take_given_spine(const std::vector<int>& joints) {
    const int given[] = {given_[Bone::spine], given_[Bone::chest], given_[Bone::upper_chest]};
    std::vector<int> taken;
    for (const int node : given) {
      if (node < 0) continue;
      if (std::find(joints.begin(), joints.end(), node) == joints.end()) return false;
      if (!taken.empty() && !strictly_below(node, taken.back())) return false;
      taken.push_back(node);
    }
    constexpr std::array kSpine{Bone::spine, Bone::chest, Bone::upper_chest};
    for (std::size_t j = 0; j < taken.size(); ++j) map_[kSpine[j]] = taken[j];
    return !taken.empty();
  }

  void find_shoulder(Bone shoulder, Bone upper_arm) {
    const int arm = map_[upper_arm];
    const int given = given_[shoulder];
    if (strictly_below(given, chest_) && strictly_below(arm, given)) {
      map_[shoulder] = given;
      return;
    }
    if (!strictly_below(arm, chest_)) return;
    const std::vector<int> joints = joints_between(chest_, tree_.node(arm).parent);
    if (!joints.empty() && tree_.apart(joints.front(), arm)) map_[shoulder] = joints.front();
  }

  [[nodiscard]] const Vec3d& at(Bone bone) const { return tree_.at(map_[bone]); }

  void find_toes(NameSide side, Bone foot, Bone toes) {
    if (strictly_below(given_[toes], map_[foot])) {
      map_[toes] = given_[toes];
      return;
    }
    const bool ankle = name(map_[foot]).part == BonePart::ankle;
    map_[toes] = first_below(named(side, {BonePart::toes}), map_[foot]);
    if (map_[toes] < 0 && ankle)
      map_[toes] = first_below(named(side, {BonePart::foot}), map_[foot]);
    if (map_[toes] >= 0) return;
    const std::vector<int> chain = tree_.chain(map_[foot], map_[foot]);
    if (!chain.empty() && !tree_.node(chain.front()).end_site) {
      map_[toes] = chain.front();
    } else {
      doubt("no {}: below {} {}", humanoid_bone_name(toes), tree_.described(map_[foot]),
            chain.empty() ? "nothing follows" : "comes only its End Site");
    }
  }

  const SkeletonTree& tree_;
  HumanoidMap given_;            // by the file or, before it, by a person …
  const HumanoidMap& asked_;     // … and these by a person
  bool any_given_ = false;       // by the file
  std::vector<BoneName> names_;  // (nodes)
  HumanoidMap map_;
  int chest_ = -1;  // where the arms meet
};

}  // namespace

std::string_view humanoid_bone_name(HumanoidBone bone) {
  constexpr std::array<std::string_view, kHumanoidBoneCount> kNames{
      "hips",
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
      "right_shoulder",
  };
  return kNames[static_cast<std::size_t>(bone)];
}

Result<HumanoidMap> find_humanoid(const Skeleton& skeleton, const std::vector<Transformd>& world,
                                  const HumanoidMap& given, const HumanoidMap& asked) {
  const SkeletonTree tree(skeleton, world);
  return BoneFinder(tree, given, asked).find();
}

}  // namespace shigusa
