// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "bone_finder.hpp"
#include "core/say.hpp"

namespace shigusa {

// Takes a limb as given by the file or the user; false if none is given, or it is no chain.
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

// Takes the first chain with the right names, and completes it from the joints around it; an
// incomplete chain is kept for the message. False if a bone is missing.
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
    // a hip at the position of its parent only carries the leg (CMU's LHipJoint)
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

// Candidate nodes for a limb's k-th bone: the user's, or those of the right side and name.
std::vector<int> BoneFinder::called(std::size_t limb, std::size_t k,
                                    const std::vector<BonePart>& parts) const {
  const int asked = asked_[kLimbs[limb][k]];
  if (asked >= 0) return {asked};
  return named(limb % 2 == 0 ? NameSide::left : NameSide::right, parts);
}

// As first_below, preferring nodes apart from the ancestor: several hinges of one joint have the
// same name.
int BoneFinder::first_apart_below(std::vector<int> nodes, int ancestor) const {
  const int first = first_below(nodes, ancestor);
  if (first < 0 || tree_.apart(first, ancestor)) return first;
  std::erase_if(nodes, [&](int i) { return !tree_.apart(i, ancestor); });
  const int apart = first_below(nodes, ancestor);
  return apart >= 0 ? apart : first;
}

// Replaces joints whose names leave a segment with hardly any length: by others of the same names
// with the most similar segments, else by shape.
void BoneFinder::give_lengths(std::size_t limb, const std::vector<int>& lowers,
                              const std::vector<int>& ends, LimbNodes& nodes) const {
  constexpr double kByShape = 2.0;  // ratio of segments from which the shape is used
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

// Finds a limb whose joints all have the same name ("arm.L", "arm.L.001", "arm.L.002"; LArm, LArm1,
// LHand; a robot's leg_left_1 to 6) by the lengths between them.
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

// Reads an arm below a shoulder as a forearm if it leads to a hand and the shoulder's segment is as
// long as an upper arm: a collar bone is shorter.
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

// A foot attached to the root as a control, near the end of a shank without one (Quaternius), or
// -1; likewise a hand.
int BoneFinder::end_beside(const std::vector<int>& ends, const LimbNodes& nodes, std::size_t limb) {
  constexpr double kNear = 0.15;  // of the segment
  // without a tip: range of the last segment's length, relative to the segment before it
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

// Hand or foot below a lower limb, whatever its name, or -1: a node named palm, the middle one of
// several, else the next joint that is no twist bone.
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
  // without another descendant, the foot is a child of the heel
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

// Skips a shoulder at the position of a collar bone with another joint before the elbow.
void BoneFinder::pass_collar(LimbNodes& nodes) const {
  if (name(nodes[0]).part != BonePart::shoulder) return;
  // ratios of upper arm to forearm; from the inner end of the collar bone it is 1.8
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

// Message on a missing limb, in terms of the file's own joints.
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

// Node at which a missing limb is expected: where the opposite limb begins, else the hips by name,
// else where another limb begins; -1 if unknown.
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
