// SPDX-License-Identifier: MIT
#include "other_build.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "core/say.hpp"
#include "core/text.hpp"
#include "human/landmark_points.hpp"
#include "humanoid_names.hpp"
#include "likeness.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

constexpr std::string_view kAnimalLimbs[] = {
    "wing",    "wings",   "fin",    "flipper", "foreleg",  "frontleg", "hindleg",
    "backleg", "rearleg", "pincer", "hoof",    "tentacle", "feather"};
constexpr std::string_view kWhichLegs[] = {"front", "fore",   "hind", "rear",
                                           "back",  "middle", "mid"};
constexpr std::string_view kFingers[] = {"thumb", "index", "pinky", "finger", "pinkie"};
constexpr std::string_view kJaws[] = {"jaw", "mouth", "face"};
constexpr std::string_view kTail[] = {"tail"};

class Build {
 public:
  Build(const SkeletonTree& tree, const HumanoidMap& map, bool by_names)
      : tree_(tree), map_(map), by_names_(by_names) {
    for (int i = 0; i < tree.size(); ++i) {
      names_.push_back(tree.node(i).end_site ? BoneName{} : read_bone_name(tree.node(i).name));
      words_.push_back(words_of(tree.node(i).name));
    }
    for (std::size_t limb = 0; limb < kLimbBones.size(); ++limb) {
      const auto& [upper, lower, end] = kLimbBones[limb];
      length_[limb] = apart(map[upper], map[lower]) + apart(map[lower], map[end]);
    }
  }

  [[nodiscard]] Message why_not() const {
    for (const auto& limb : kLimbBones) {
      for (const Bone bone : limb) {
        if (is_animals(map_[bone])) return say("animals_limb", tree_.described(map_[bone]));
      }
    }
    if (Message fingers = fingers_for_limbs(); !fingers.empty()) return fingers;
    if (Message head = arms_on_head(); !head.empty()) return head;
    if (Message more = more_by_names(); !more.empty()) return more;
    if (Message more = more_to_the_floor(); !more.empty()) return more;
    return on_four();
  }

 private:
  [[nodiscard]] const BoneName& name(int i) const { return names_[index(i)]; }
  [[nodiscard]] double apart(int a, int b) const { return norm(tree_.at(a) - tree_.at(b)); }
  [[nodiscard]] bool has(int i, std::span<const std::string_view> list) const {
    const auto& words = words_[index(i)];
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return contains(list, word); });
  }

  [[nodiscard]] bool is_animals(int i) const {
    constexpr std::string_view kLeg[] = {"leg", "upleg", "lowleg", "upperleg", "lowerleg"};
    return has(i, kAnimalLimbs) || (has(i, kWhichLegs) && has(i, kLeg));
  }

  [[nodiscard]] Message fingers_for_limbs() const {
    for (const Bone upper : {Bone::left_upper_leg, Bone::left_upper_arm}) {
      if (has(map_[upper], kFingers)) return say("fingers_for_limbs", tree_.described(map_[upper]));
    }
    return {};
  }

  [[nodiscard]] Message arms_on_head() const {
    int i = tree_.common_ancestor(map_[Bone::left_upper_arm], map_[Bone::right_upper_arm]);
    for (; i >= 0 && i != map_[Bone::hips]; i = tree_.node(i).parent) {
      if (name(i).part == BonePart::head || has(i, kJaws)) {
        return say("arms_on_head", tree_.described(i));
      }
    }
    return {};
  }

  // Whether a node belongs to a limb's own chain, or coincides with its nodes as control bones do.
  [[nodiscard]] bool is_of_limb(int i, std::size_t limb) const {
    constexpr double kSame = 0.25;  // of the limb
    const auto& bones = kLimbBones[limb];
    if (tree_.below(i, map_[bones[0]]) || tree_.below(map_[bones[0]], i)) return true;
    return std::any_of(bones.begin(), bones.end(),
                       [&](Bone bone) { return apart(i, map_[bone]) < kSame * length_[limb]; });
  }

  // Reason from further legs or arms by name: joints beside the person's, each with a child joint.
  [[nodiscard]] Message more_by_names() const {
    using P = BonePart;
    constexpr std::array kUppers{std::array{P::upper_leg, P::leg},
                                 std::array{P::upper_arm, P::arm}};
    constexpr std::array kLowers{std::array{P::lower_leg, P::leg, P::foot},
                                 std::array{P::lower_arm, P::arm, P::hand}};
    for (std::size_t limb = 0; limb < kLimbBones.size(); ++limb) {
      const NameSide side = limb % 2 == 0 ? NameSide::left : NameSide::right;
      const auto& uppers = kUppers[limb / 2];
      const auto& lowers = kLowers[limb / 2];
      for (int upper = 0; upper < tree_.size(); ++upper) {
        if (name(upper).side != side || !contains(uppers, name(upper).part)) continue;
        for (int lower = upper + 1; lower < tree_.size(); ++lower) {
          const bool next = name(lower).side == side && contains(lowers, name(lower).part) &&
                            tree_.below(lower, upper);
          if (!next || is_of_limb(upper, limb) || is_of_limb(lower, limb)) continue;
          return say(limb < 2 ? OfLimbs("more_legs") : OfLimbs("more_arms"),
                     tree_.described(upper));
        }
      }
    }
    return {};
  }

  // Reason from pairs of chains below the trunk, beside the limbs, that reach down to the feet.
  [[nodiscard]] Message more_to_the_floor() const {
    if (by_names_) return {};
    constexpr double kLeast = 0.6;  // of a leg
    constexpr double kLow = 0.25;
    constexpr double kAside = 0.5;
    const double leg = min(length_[0], length_[1]);
    const Vec3d hips =
        (tree_.at(map_[Bone::left_upper_leg]) + tree_.at(map_[Bone::right_upper_leg])) * 0.5;
    const Vec3d feet = (tree_.at(tree_.farthest(map_[Bone::left_foot])) +
                        tree_.at(tree_.farthest(map_[Bone::right_foot]))) *
                       0.5;
    const Vec3d down = normalized(feet - hips, {});
    const double floor = dot(feet, down);
    // bones of a skirt are beside the legs
    const auto is_low = [&](int i) {
      const Vec3d off = tree_.at(i) - hips;
      return dot(tree_.at(i), down) > floor - kLow * leg &&
             norm(off - down * dot(off, down)) > kAside * leg;
    };
    int first = -1;
    int count = 0;
    for (const Bone hand : {Bone::left_hand, Bone::right_hand}) {
      if (is_low(tree_.farthest(map_[hand]))) ++count;
    }
    for (int i = 0; i < tree_.size(); ++i) {
      const int parent = tree_.node(i).parent;
      if (parent < 0 || !is_trunk(parent) || is_trunk(i) || bears_limb(i)) continue;
      if (name(i).part == BonePart::ornament) continue;
      const std::vector<int> chain = tree_.chain(parent, i);
      constexpr std::size_t kFewest = 3;
      if (chain.size() < kFewest || tree_.reach(i) < kLeast * leg) continue;
      if (!is_low(chain.back())) continue;
      ++count;
      if (first < 0) first = i;
    }
    constexpr int kMost = 3;
    return count > kMost && first >= 0 ? say("legs_to_the_floor", count, tree_.described(first))
                                       : Message();
  }

  // Whether a node has limbs of several kinds below it, or lies between their junction and the
  // head.
  [[nodiscard]] bool is_trunk(int i) const {
    const int hips = map_[Bone::hips];
    const int chest =
        tree_.common_ancestor(map_[Bone::left_upper_arm], map_[Bone::right_upper_arm]);
    return i == hips || i == chest || (tree_.below(i, hips) && tree_.below(chest, i));
  }
  [[nodiscard]] bool bears_limb(int i) const {
    return std::any_of(kLimbBones.begin(), kLimbBones.end(),
                       [&](const LimbBones& limb) { return tree_.below(map_[limb[0]], i); });
  }

  [[nodiscard]] Message on_four() const {
    Landmarks limbs;
    for (const Side side : kBothSides) {
      const auto& [hip, knee, ankle] = leg_bones(side);
      const auto& [shoulder, elbow, wrist] = arm_bones(side);
      const auto at = [&](Bone bone) { return tree_.at(map_[bone]); };
      limbs.leg(side) = {at(hip), at(knee), at(ankle), {}};
      limbs.arm(side) = {at(shoulder), at(elbow), at(wrist), {}};
    }
    // fingers of one hand: the trunk would point in the direction of the legs
    constexpr double kAlong = 0.5;
    const Vec3d trunk = normalized(mid_shoulder(limbs) - mid_hip(limbs), {});
    const Vec3d legs = (limbs.left_leg.ankle + limbs.right_leg.ankle) * 0.5 - mid_hip(limbs);
    if (!by_names_ && dot(trunk, normalized(legs, {})) > kAlong) return say("four_limbs_down");
    // limbs with an animal's lengths are reported by unlike_a_person
    if (!stands_on_four(limbs) || !unlike_a_person(limbs).empty()) return {};
    for (int i = 0; i < tree_.size(); ++i) {
      if (has(i, kTail)) return say("four_legs_and_tail", tree_.described(i));
    }
    return by_names_ ? Message() : say("four_limbs_down");
  }

  using OfLimbs = Sentence<std::string>;

  const SkeletonTree& tree_;
  const HumanoidMap& map_;
  bool by_names_;
  std::vector<BoneName> names_;                  // (nodes)
  std::vector<std::vector<std::string>> words_;  // (nodes)
  std::array<double, 4> length_{};               // of the limbs
};

}  // namespace

Message unlike_a_persons_build(const SkeletonTree& tree, const HumanoidMap& map, bool by_names) {
  return Build(tree, map, by_names).why_not();
}

}  // namespace shigusa
