// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "bone_finder.hpp"
#include "core/say.hpp"

namespace shigusa {

// A limb as the file or a person tells it; false where they tell none, or no chain.
bool BoneFinder::take_given(std::size_t limb) {
  const auto& [upper, lower, end] = kLimbs[limb];
  if (!strictly_below(given_[lower], given_[upper]) ||
      !strictly_below(given_[end], given_[lower])) {
    if (!any_given_) return false;
    doubt("map_without_limb", kLimbNames[limb]);
    return false;
  }
  for (const Bone bone : kLimbs[limb]) map_[bone] = given_[bone];
  return true;
}

// Takes the first chain with the right names, and what is missing of it from the joints around it;
// of an incomplete one what there is, for the message. False where a bone is missing.
bool BoneFinder::find_by_name(std::size_t limb) {
  using P = BonePart;
  const bool leg = limb < 2;
  const std::vector<int> uppers = called(limb, 0,
                                         leg ? std::vector{P::upper_leg, P::hip, P::leg}
                                             : std::vector{P::upper_arm, P::arm, P::shoulder});
  const std::vector<int> lowers =
      called(limb, 1, leg ? std::vector{P::lower_leg, P::leg} : std::vector{P::lower_arm});
  const std::vector<int> ends =
      called(limb, 2, leg ? std::vector{P::ankle, P::foot} : std::vector{P::hand});
  LimbNodes best{-1, -1, -1};
  for (const int upper : uppers) {
    // a hip at the very place of its parent only carries the leg (CMU's LHipJoint)
    if (name(upper).part == P::hip && at_parent(upper)) continue;
    const int lower = first_apart_below(lowers, upper);
    const int end = lower < 0 ? -1 : first_apart_below(ends, lower);
    if (best[0] < 0 || (best[1] < 0 && lower >= 0) || end >= 0) best = {upper, lower, end};
    if (end >= 0) break;
  }
  find_in_row(limb, ends, best);
  if (best[1] < 0 && best[0] >= 0) read_arm_as_forearm(uppers, ends, best);
  if (best[1] >= 0 && best[2] < 0) best[2] = end_beside(ends, best, limb);
  if (best[1] >= 0 && best[2] < 0) best[2] = end_below(best, limb);
  if (best[2] >= 0) pass_collar(best);
  if (best[2] >= 0) give_lengths(limb, lowers, ends, best);
  for (std::size_t k = 0; k < 3; ++k) map_[kLimbs[limb][k]] = best[k];
  return best[2] >= 0;
}

// The nodes of a limb's k-th bone: what a person asks for, or those of the right side and name.
std::vector<int> BoneFinder::called(std::size_t limb, std::size_t k,
                                    const std::vector<BonePart>& parts) const {
  const int asked = asked_[kLimbs[limb][k]];
  if (asked >= 0) return {asked};
  return named(limb % 2 == 0 ? NameSide::left : NameSide::right, parts);
}

// As first_below, of those that stand apart from the ancestor where any do: several hinges of one
// joint have the same name.
int BoneFinder::first_apart_below(std::vector<int> nodes, int ancestor) const {
  const int first = first_below(nodes, ancestor);
  if (first < 0 || tree_.apart(first, ancestor)) return first;
  std::erase_if(nodes, [&](int i) { return !tree_.apart(i, ancestor); });
  const int apart = first_below(nodes, ancestor);
  return apart >= 0 ? apart : first;
}

// Names yield where they leave a segment hardly any length: to other joints of the same names, of
// which the segments are most alike, else to the shape.
void BoneFinder::give_lengths(std::size_t limb, const std::vector<int>& lowers,
                              const std::vector<int>& ends, LimbNodes& nodes) const {
  constexpr double kByShape = 2.0;  // unevenness of segments without names
  const auto unevenness = [&](const LimbNodes& n) {
    const double upper = norm(tree_.at(n[1]) - tree_.at(n[0]));
    const double lower = norm(tree_.at(n[2]) - tree_.at(n[1]));
    return max(upper, lower) / max(min(upper, lower), 1e-9 * tree_.extent());
  };
  const auto& bones = kLimbs[limb];
  const bool asked =
      std::any_of(bones.begin(), bones.end(), [this](Bone bone) { return asked_[bone] >= 0; });
  if (asked || unevenness(nodes) <= kMostUnevenSegments) return;
  LimbNodes best = nodes;
  const auto consider = [&](const LimbNodes& other) {
    if (unevenness(other) < unevenness(best)) best = other;
  };
  for (const int lower : lowers) {
    if (!strictly_below(lower, nodes[0])) continue;
    for (const int end : ends) {
      if (strictly_below(end, lower)) consider({nodes[0], lower, end});
    }
  }
  const auto by_shape = limb_joints(tree_, nodes[0], limb >= 2);
  if (by_shape && unevenness(*by_shape) <= kByShape && unevenness(best) > kMostUnevenSegments) {
    best = *by_shape;
  }
  nodes = best;
}

// A limb whose joints are all called the same ("arm.L", "arm.L.001", "arm.L.002"; LArm, LArm1,
// LHand; a robot's leg_left_1 to 6): by the lengths between them.
void BoneFinder::find_in_row(std::size_t limb, const std::vector<int>& ends,
                             LimbNodes& nodes) const {
  const BonePart part = nodes[0] < 0 ? BonePart::none : name(nodes[0]).part;
  const bool row = part == BonePart::arm || part == BonePart::leg;
  if (!row || nodes[2] >= 0 || (nodes[1] >= 0 && name(nodes[1]).part != part)) return;
  const int end = first_below(ends, nodes[0]);
  if (end < 0) {
    nodes = limb_joints(tree_, nodes[0], limb >= 2).value_or(nodes);
    return;
  }
  const auto off_middle = [&](int i) {
    return abs(norm(tree_.at(i) - tree_.at(nodes[0])) - norm(tree_.at(end) - tree_.at(i)));
  };
  for (const int i : called(limb, 1, {part})) {
    if (!strictly_below(i, nodes[0]) || !strictly_below(end, i)) continue;
    if (nodes[1] < 0 || off_middle(i) < off_middle(nodes[1])) nodes[1] = i;
  }
  nodes[2] = nodes[1] < 0 ? -1 : end;
}

// An arm below a shoulder is a forearm where it leads to a hand and the shoulder before it is of an
// upper arm's length: a collar bone is shorter.
void BoneFinder::read_arm_as_forearm(const std::vector<int>& uppers, const std::vector<int>& ends,
                                     LimbNodes& nodes) const {
  constexpr double kShortest = 0.5;  // of the forearm
  const int end = first_below(ends, nodes[0]);
  if (end < 0) return;
  const auto length = [&](int from, int to) { return norm(tree_.at(to) - tree_.at(from)); };
  for (const int upper : uppers) {
    if (name(upper).part != BonePart::shoulder || !strictly_below(nodes[0], upper)) continue;
    if (length(upper, nodes[0]) < kShortest * length(nodes[0], end)) continue;
    nodes = {upper, nodes[0], end};
    return;
  }
}

// A foot that hangs on a root, as a control, at the end of a shank without one (Quaternius), or
// -1; likewise a hand.
int BoneFinder::end_beside(const std::vector<int>& ends, const LimbNodes& nodes, std::size_t limb) {
  constexpr double kNear = 0.15;  // of the segment
  // without a tip: lengths of the segment before the end, in those of the one before it
  constexpr double kShortest = 0.5;
  constexpr double kLongest = 2.0;
  const Vec3d& joint = tree_.at(nodes[1]);
  const double before = norm(joint - tree_.at(nodes[0]));
  const int tip = tree_.farthest(nodes[1], [&](int i) { return name(i).part == BonePart::heel; });
  for (const int end : ends) {
    if (tree_.below(nodes[1], end) || tree_.below(end, nodes[1])) continue;
    const double length = norm(tree_.at(end) - joint);
    const bool at_tip = norm(tree_.at(end) - tree_.at(tip)) <= kNear * norm(tree_.at(tip) - joint);
    const bool stretched = norm(tree_.at(end) - tree_.at(nodes[0])) > before;
    const bool in_place = length > kShortest * before && length < kLongest * before && stretched;
    const bool asked = asked_[kLimbs[limb][2]] == end;
    if (!asked && (tip == nodes[1] ? !in_place : !at_tip)) continue;
    doubt("loose_end", tree_.described(end), kLimbNames[limb]);
    return end;
  }
  return -1;
}

// The joint below a lower limb that is its hand or foot, whatever it is called, or -1: what is
// called a palm, of several the one in their middle, else the next joint but for twist bones.
int BoneFinder::end_below(const LimbNodes& nodes, std::size_t limb) {
  const NameSide side = limb % 2 == 0 ? NameSide::left : NameSide::right;
  std::vector<int> palms;
  for (const int i : limb < 2 ? std::vector<int>{} : named(side, {BonePart::palm})) {
    const auto above = [&](int palm) { return tree_.below(i, palm); };
    if (strictly_below(i, nodes[1]) && std::none_of(palms.begin(), palms.end(), above)) {
      palms.push_back(i);
    }
  }
  if (!palms.empty()) return nearest_to_mean(palms);
  constexpr double kShare = 0.5;  // of the segment before
  const double least = kShare * norm(tree_.at(nodes[1]) - tree_.at(nodes[0]));
  const auto is_other = [&](int i) {
    const BonePart part = name(i).part;
    return part == BonePart::thumb || part == BonePart::ornament || part == BonePart::heel;
  };
  const int tip = tree_.farthest(nodes[1], is_other);
  // where nothing else follows, the foot hangs on the heel
  if (tip == nodes[1] && limb < 2) return first_below(named(side, {BonePart::heel}), nodes[1]);
  std::vector<int> chain;
  for (int i = tip; i != nodes[1]; i = tree_.node(i).parent) chain.push_back(i);
  for (auto i = chain.rbegin(); i != chain.rend(); ++i) {
    if (norm(tree_.at(*i) - tree_.at(nodes[1])) < least || is_twist_name(tree_.node(*i).name)) {
      continue;
    }
    if (tree_.node(*i).end_site) return -1;
    if (tree_.children(tree_.node(*i).parent).size() > 1) {
      doubt("end_by_place", tree_.described(*i), kLimbNames[limb]);
    }
    return *i;
  }
  return -1;
}

int BoneFinder::nearest_to_mean(const std::vector<int>& nodes) const {
  Vec3d mean{};
  for (const int i : nodes) mean += tree_.at(i) * (1.0 / static_cast<double>(nodes.size()));
  return *std::min_element(nodes.begin(), nodes.end(), [&](int a, int b) {
    return norm(tree_.at(a) - mean) < norm(tree_.at(b) - mean);
  });
}

// A shoulder that stands where a collar bone does, with another joint before the elbow, is one.
void BoneFinder::pass_collar(LimbNodes& nodes) const {
  if (name(nodes[0]).part != BonePart::shoulder) return;
  // of people's upper arms to their forearms; from the inner end of the collar bone it is 1.8
  constexpr double kLongest = 1.5;
  constexpr double kUsual = 1.2;
  const double forearm = norm(tree_.at(nodes[2]) - tree_.at(nodes[1]));
  const auto ratio = [&](int i) { return norm(tree_.at(nodes[1]) - tree_.at(i)) / forearm; };
  if (!(ratio(nodes[0]) > kLongest)) return;
  const int collar = nodes[0];
  for (int i = tree_.node(nodes[1]).parent; i != collar; i = tree_.node(i).parent) {
    if (abs(ratio(i) - kUsual) < abs(ratio(nodes[0]) - kUsual)) nodes[0] = i;
  }
}

// The file's state where a limb is missing, in terms of the file's own joints.
Message BoneFinder::missing(std::size_t limb) const {
  for (std::size_t k = 1; k < 3; ++k) {
    const int above = map_[kLimbs[limb][k - 1]];
    if (above < 0 || map_[kLimbs[limb][k]] >= 0) continue;
    const std::vector<int> chain = tree_.chain(above, above);
    return say("no_bone_below", humanoid_bone_name(kLimbs[limb][k]), tree_.described(above),
               chain.empty() ? "nothing follows" : "comes only " + tree_.described(chain.front()));
  }
  const int from = hub(limb);
  if (from < 0) return missing_by_shape(tree_);
  return say("no_limb", kLimbNames[limb], describe_branches(tree_, from, limb < 2));
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
