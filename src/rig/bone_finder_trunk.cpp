// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"
#include "bone_finder.hpp"
#include "core/say.hpp"
#include "facing.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

constexpr std::array kSpine{Bone::spine, Bone::chest, Bone::upper_chest};
// Least height of a spine's lowest joint above the hip joints, as a share of the way to the neck.
constexpr double kLeastSpine = 0.03;

}  // namespace

bool BoneFinder::find_hips() {
  const auto meet = [&](Bone a, Bone b) { return tree_.common_ancestor(map_[a], map_[b]); };
  int legs = meet(Bone::left_upper_leg, Bone::right_upper_leg);
  chest_ = meet(Bone::left_upper_arm, Bone::right_upper_arm);
  int all = legs < 0 || chest_ < 0 ? -1 : tree_.common_ancestor(legs, chest_);
  if (all < 0) return false;
  if (const int trunk = deforming_trunk(); trunk >= 0 && !tree_.below(chest_, trunk)) {
    all = tree_.common_ancestor(all, trunk);
    if (all < 0) return false;
    chest_ = legs = all;
    flat_ = true;
  }
  // a root in the chest: the legs have their common ancestor below it
  const int lowest = all == chest_ ? legs : all;
  map_[Bone::hips] = lowest;
  const int given = given_[Bone::hips];
  if (given >= 0 && tree_.below(lowest, given)) {
    map_[Bone::hips] = given;
    return true;
  }
  if (any_given_) doubt("map_without_hips");
  for (int i = 0; i <= lowest; ++i) {
    const bool named_hips = name(i).part == BonePart::hips || name(i).part == BonePart::hip;
    if (named_hips && name(i).side == NameSide::none && tree_.below(lowest, i)) {
      map_[Bone::hips] = i;
    }
  }
  return true;
}

// First trunk bone prefixed DEF-, if the limbs have those, or -1.
int BoneFinder::deforming_trunk() const {
  const auto is_trunk = [this](int i) { return name(i).part == BonePart::spine && deforms(i); };
  for (int i = 0; deforming_only_ && i < tree_.size(); ++i) {
    if (is_trunk(i)) return i;
  }
  return -1;
}

// Finds the trunk as a branch beside the limbs if all limbs leave one node, as in the deforming
// bones of a Rigify rig: its last joint below the shoulders carries neck and head.
void BoneFinder::find_trunk_branch() {
  // the collar bones of 3ds Max' Biped are children of the neck
  const bool neck = read_bone_name(tree_.node(chest_).name).part == BonePart::neck;
  if (neck && strictly_below(chest_, map_[Bone::hips])) {
    chest_ = tree_.node(chest_).parent;
  }
  const Vec3d from = mid(Bone::left_upper_leg, Bone::right_upper_leg);
  const Vec3d trunk = mid(Bone::left_upper_arm, Bone::right_upper_arm) - from;
  const int legs = tree_.common_ancestor(map_[Bone::left_upper_leg], map_[Bone::right_upper_leg]);
  if (chest_ != legs && !flat_) return;
  constexpr double kShoulders = 0.9;  // of the way
  constexpr double kAside = 0.3;
  for (const int child : tree_.children(chest_)) {
    if (bears_limb(child)) continue;
    int last = -1;
    bool goes_on = false;
    for (const int i : tree_.chain(chest_, child)) {
      const Vec3d off = tree_.at(i) - from;
      const double share = dot(off, trunk) / dot(trunk, trunk);
      const bool beside = norm(off - trunk * share) <= kAside * norm(trunk);
      if (beside && share > 0.0 && share < kShoulders) last = i;
      goes_on = goes_on || (last >= 0 && beside && share >= kShoulders);
    }
    if (!goes_on) continue;
    chest_ = last;
    flat_ = true;
    doubt("limbs_elsewhere", tree_.described(map_[Bone::hips]), tree_.described(child));
    return;
  }
}

void BoneFinder::find_neck_and_head() {
  int& neck = map_[Bone::neck];
  int& head = map_[Bone::head];
  const std::vector<int> necks = named(NameSide::none, {BonePart::neck});
  const bool neck_given = strictly_below(given_[Bone::neck], chest_);
  neck = neck_given ? given_[Bone::neck] : first_below(necks, chest_);
  // a neck joint at the position of the chest is a helper if another one follows
  const int upper_neck = neck < 0 || neck_given ? -1 : first_below(necks, neck);
  if (upper_neck >= 0 && at_parent(neck) && tree_.apart(upper_neck, neck)) neck = upper_neck;
  const int trunk_end = neck >= 0 ? neck : chest_;
  head = strictly_below(given_[Bone::head], trunk_end)
             ? given_[Bone::head]
             : first_below(named(NameSide::none, {BonePart::head}), trunk_end);
  if (head < 0) head = head_by_shape();
  if (neck < 0 && head >= 0) neck = neck_by_shape(head);
  if (neck < 0) doubt("no_neck");
  if (head < 0) doubt("no_head");
}

bool BoneFinder::bears_limb(int i) const {
  return std::any_of(kLimbs.begin(), kLimbs.end(),
                     [&](const LimbBones& limb) { return tree_.below(map_[limb[0]], i); });
}

// Node at which the chain upwards from the neck ends or forks, or the face begins; without a neck,
// that of the longest branch beside the limbs.
int BoneFinder::head_by_shape() const {
  const int neck = map_[Bone::neck];
  int at = neck >= 0 ? neck : way_up(chest_);
  int head = -1;
  const auto is_tip = [&](int i) {
    return tree_.node(i).end_site || name(i).part == BonePart::tip;
  };
  while (at >= 0 && !is_tip(at)) {
    if (at != neck && (head < 0 || tree_.apart(at, head))) head = at;
    const int next = way_up(at);
    if (head >= 0 && tree_.children(at).size() > 1 && !in_row(at, next)) break;
    at = next;
  }
  return head;
}

// Whether two nodes follow one another in a numbered row of the spine.
bool BoneFinder::in_row(int i, int next) const {
  const BonePart part = name(i).part;
  return next >= 0 && (part == BonePart::spine || part == BonePart::neck) &&
         is_next_in_row(tree_.node(i).name, tree_.node(next).name);
}

// Child of a node towards the head: the next of a numbered row ("spine.004" above "spine.003"),
// else the one with the longest chain among those without a side that are no limb, ornament or tip;
// -1 if there is none.
int BoneFinder::way_up(int i) const {
  constexpr double kShortest = 0.02;  // of the figure
  int best = -1;
  double longest = i == chest_ ? kShortest * tree_.extent() : -1.0;
  for (const int child : tree_.children(i)) {
    if (bears_limb(child) || name(child).part == BonePart::ornament) continue;
    if (in_row(i, child)) return child;
    const double length = norm(tree_.at(child) - tree_.at(i)) + tree_.reach(child);
    if (name(child).side != NameSide::none || length <= longest) continue;
    best = child;
    longest = length;
  }
  return best;
}

// Lowest joint between chest and head that is apart from both.
int BoneFinder::neck_by_shape(int head) const {
  int neck = -1;
  for (int i = tree_.node(head).parent; i >= 0 && i != chest_; i = tree_.node(i).parent) {
    if (tree_.apart(i, chest_) && tree_.apart(i, head)) neck = i;
  }
  return neck;
}

// Joints from `end` up to, but not including, `top` that are apart from it and from one another,
// from above.
std::vector<int> BoneFinder::joints_between(int top, int end) const {
  std::vector<int> joints;
  for (int i = end; i >= 0 && i != top; i = tree_.node(i).parent) {
    if (!tree_.apart(i, top)) continue;
    // of several at one point the bone is the first
    if (!joints.empty() && !tree_.apart(i, joints.front())) joints.erase(joints.begin());
    joints.insert(joints.begin(), i);
  }
  return joints;
}

void BoneFinder::find_spine() {
  const int hips = map_[Bone::hips];
  if (chest_ == hips || !tree_.below(chest_, hips)) return;
  std::vector<int> joints = joints_between(hips, chest_);
  if (take_given_spine(joints)) return;
  const Vec3d from = mid(Bone::left_upper_leg, Bone::right_upper_leg);
  const Vec3d to =
      map_[Bone::neck] >= 0 ? at(Bone::neck) : mid(Bone::left_upper_arm, Bone::right_upper_arm);
  const Vec3d trunk = to - from;
  const auto share = [&](int i) { return dot(tree_.at(i) - from, trunk) / dot(trunk, trunk); };
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

// Takes the file's own spine if it is given and on the path; bones that it leaves out stay
// unmapped.
bool BoneFinder::take_given_spine(const std::vector<int>& joints) {
  std::vector<int> taken;
  for (const Bone bone : kSpine) {
    const int node = given_[bone];
    if (node < 0) continue;
    if (std::find(joints.begin(), joints.end(), node) == joints.end()) return false;
    if (!taken.empty() && !strictly_below(node, taken.back())) return false;
    taken.push_back(node);
  }
  for (std::size_t j = 0; j < taken.size(); ++j) map_[kSpine[j]] = taken[j];
  return !taken.empty();
}

void BoneFinder::find_shoulder(Bone shoulder, Bone upper_arm) {
  const int arm = map_[upper_arm];
  const int given = given_[shoulder];
  if (strictly_below(given, chest_) && strictly_below(arm, given)) {
    map_[shoulder] = given;
    return;
  }
  // a VRM animation could not move it
  if (given < 0 && given_[upper_arm] == arm && any_given_) return;
  if (flat_) find_collar_beside(shoulder, arm);
  if (!strictly_below(arm, chest_)) return;
  const int fork = tree_.common_ancestor(map_[Bone::left_upper_arm], map_[Bone::right_upper_arm]);
  const std::vector<int> joints = joints_between(fork, tree_.node(arm).parent);
  if (!joints.empty() && tree_.apart(joints.front(), arm)) map_[shoulder] = joints.front();
}

// Finds the collar bone of a limb without a trunk, as given or by its name.
void BoneFinder::find_collar_beside(Bone shoulder, int arm) {
  const NameSide side = shoulder == Bone::left_shoulder ? NameSide::left : NameSide::right;
  std::vector<int> collars = named(side, {BonePart::collar, BonePart::shoulder});
  if (const int given = given_[shoulder]; given >= 0) collars.insert(collars.begin(), given);
  for (const int i : collars) {
    const bool bears_limb = tree_.below(arm, i) || tree_.below(i, arm);
    if (bears_limb || !tree_.apart(i, arm)) continue;
    map_[shoulder] = i;
    return;
  }
}

void BoneFinder::find_toes(Side of, Bone toes) {
  const NameSide side = of == Side::left ? NameSide::left : NameSide::right;
  const Bone shank = leg_bones(of)[1];
  const Bone foot = leg_bones(of)[2];
  if (strictly_below(given_[toes], map_[foot])) {
    map_[toes] = given_[toes];
    return;
  }
  const bool ankle = name(map_[foot]).part == BonePart::ankle;
  map_[toes] = first_below(named(side, {BonePart::toes}), map_[foot]);
  // below an ankle the foot may be at the ball, with the toes as its tip
  const int ball = ankle ? first_below(named(side, {BonePart::foot}), map_[foot]) : -1;
  const auto off = [&](int i) {
    const double length = norm(tree_.at(tree_.farthest(map_[foot])) - at(foot));
    return i < 0 ? 1e9 : abs(norm(tree_.at(i) - at(foot)) - kToesShare * length);
  };
  if (off(ball) < off(map_[toes])) map_[toes] = ball;
  if (map_[toes] >= 0) return;
  int next = -1;
  for (int i = foot_tip(tree_, map_[shank], map_[foot]); i != map_[foot];
       i = tree_.node(i).parent) {
    if (tree_.apart(i, map_[foot])) next = i;
  }
  if (next >= 0 && !tree_.node(next).end_site) {
    map_[toes] = next;
  } else {
    doubt("no_bone_below", humanoid_bone_name(toes), tree_.described(map_[foot]),
          next >= 0                                  ? "comes only its End Site"
          : tree_.farthest(map_[foot]) == map_[foot] ? "nothing follows"
                                                     : "comes only its heel");
  }
}

}  // namespace shigusa
