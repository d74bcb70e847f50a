// SPDX-License-Identifier: MIT
#include "rig/twist_bones.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "humanoid_names.hpp"
#include "skeleton_tree.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

// Largest distance from the limb's line, in its lengths, of a node between two bones and of one by
// name.
constexpr double kOnLine = 0.03;
constexpr double kBesideLine = 0.15;
// Least distance from both bones of a node between them, as a share of their distance; nearer ones
// are helpers.
constexpr double kApart = 0.1;
constexpr double kBeyond = 0.05;
// Position nearest to the joint: if all twist bones of a lower limb are nearer, positions determine
// no shares.
constexpr double kAtTheJoint = 0.2;

class TwistFinder {
 public:
  TwistFinder(const Skeleton& skeleton, const std::vector<Transformd>& world,
              const HumanoidMap& map)
      : tree_(skeleton, world), map_(map), found_(skeleton.nodes.size(), false) {}

  std::vector<TwistBone> find() {
    // in chains first: a node may be within one limb and beside another
    for (const bool chains : {true, false}) {
      for (const TwistSegment& segment : twist_segments()) {
        if (map_[segment.bone] < 0 || map_[segment.next] < 0) continue;
        if (!tree_.below(map_[segment.next], map_[segment.bone])) continue;
        const std::size_t before = twists_.size();
        for (int i = 0; i < tree_.size(); ++i) consider(i, segment, chains);
        if (!chains && segment.lower) spread(segment, before);
      }
    }
    std::stable_sort(twists_.begin(), twists_.end(),
                     [](const TwistBone& a, const TwistBone& b) { return a.node < b.node; });
    return std::move(twists_);
  }

 private:
  void consider(int i, const TwistSegment& segment, bool chains) {
    const auto [bone, next, lower] = segment;
    const int from = map_[bone];
    const int to = map_[next];
    if (i == from || i == to || tree_.node(i).end_site || found_[index(i)]) {
      return;
    }
    const Vec3d limb = tree_.at(to) - tree_.at(from);
    const double length = norm(limb);
    if (!(length > 0.0)) return;
    const Vec3d at = tree_.at(i) - tree_.at(from);
    const double share = dot(at, limb) / (length * length);
    const double off = norm(at - limb * share) / length;
    const bool chain = tree_.below(i, from) && tree_.below(to, i);
    if (chain != chains) return;
    const bool apart = share >= kApart && share <= 1.0 - kApart;
    const bool named = is_twist_name(tree_.node(i).name);
    if (chain ? !(apart && off <= (named ? kBesideLine : kOnLine)) : !named) return;
    if (!chain && !(beside(i, from, to) && off <= kBesideLine && share >= -kBeyond &&
                    share <= 1.0 + kBeyond)) {
      return;
    }
    found_[index(i)] = true;
    twists_.push_back({i, bone, clamp(share, 0.0, 1.0), chain});
  }

  // Whether a node is below the limb's bone but not the next one, or below that bone's parent, and
  // has no bone below it.
  [[nodiscard]] bool beside(int i, int from, int to) const {
    for (const int bone : map_.node) {
      if (bone >= 0 && tree_.below(bone, i)) return false;
    }
    const bool below = tree_.below(i, from) && !tree_.below(i, to);
    return below || (tree_.node(i).parent >= 0 && tree_.node(i).parent == tree_.node(from).parent);
  }

  void spread(const TwistSegment& segment, std::size_t before) {
    const auto of_segment = [&](const TwistBone& t) { return t.bone == segment.bone; };
    const bool all_near = std::all_of(twists_.begin(), twists_.end(), [&](const TwistBone& t) {
      return !of_segment(t) || t.share < kAtTheJoint;
    });
    const std::size_t count = twists_.size() - before;
    if (!all_near) return;
    for (std::size_t k = 0; k < count; ++k) {
      twists_[before + k].share = static_cast<double>(k + 1) / static_cast<double>(count + 1);
    }
  }

  SkeletonTree tree_;
  const HumanoidMap& map_;
  std::vector<bool> found_;  // (nodes)
  std::vector<TwistBone> twists_;
};

}  // namespace

const std::array<TwistSegment, 8>& twist_segments() {
  static constexpr std::array<TwistSegment, 8> kSegments{{
      {Bone::left_upper_arm, Bone::left_lower_arm, false},
      {Bone::right_upper_arm, Bone::right_lower_arm, false},
      {Bone::left_lower_arm, Bone::left_hand, true},
      {Bone::right_lower_arm, Bone::right_hand, true},
      {Bone::left_upper_leg, Bone::left_lower_leg, false},
      {Bone::right_upper_leg, Bone::right_lower_leg, false},
      {Bone::left_lower_leg, Bone::left_foot, true},
      {Bone::right_lower_leg, Bone::right_foot, true},
  }};
  return kSegments;
}

std::vector<TwistBone> find_twist_bones(const Skeleton& skeleton,
                                        const std::vector<Transformd>& world,
                                        const HumanoidMap& map) {
  return TwistFinder(skeleton, world, map).find();
}

bool untwisted(const std::vector<TwistBone>& twists, HumanoidBone bone) {
  const auto& segments = twist_segments();
  const auto segment = std::find_if(segments.begin(), segments.end(),
                                    [&](const TwistSegment& s) { return s.bone == bone; });
  if (segment == segments.end()) return false;
  return std::any_of(twists.begin(), twists.end(), [&](const TwistBone& t) {
    return t.bone == bone && (segment->lower || t.chain);
  });
}

}  // namespace shigusa
