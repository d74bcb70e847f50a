// SPDX-License-Identifier: MIT
#include "facing.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "human/landmark_points.hpp"
#include "humanoid_names.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

// Words of nodes ahead of the head or the trunk, and of others behind it.
constexpr std::string_view kFace[] = {"eye", "eyes", "eyeball", "jaw",    "nose", "nostril",
                                      "lip", "lips", "mouth",   "tongue", "chin", "teeth"};
constexpr std::string_view kFront[] = {"breast", "breasts", "bust", "boob", "belly"};
constexpr std::string_view kBack[] = {"tail",  "wing", "wings",   "backpack",
                                      "cloak", "cape", "ponytail"};

// Horizontal centre of the foot's mesh relative to its ankle, and whether it is clearly to one
// side.
struct FootMesh {
  Vec3d middle{};
  bool clear = false;
};

Vec3d across(const Vec3d& v, const Vec3d& axis) { return v - axis * dot(v, axis); }

FootMesh foot_mesh(const SkeletonTree& tree, int knee, int ankle) {
  constexpr double kClearly = 1.4;  // ratio of the extents ahead of and behind the ankle
  const Vec3d shank = normalized(tree.at(knee) - tree.at(ankle));
  std::vector<Vec3d> flesh;
  Vec3d sum{};
  for (const SkinVertex& vertex : tree.skin()) {
    if (vertex.node < 0 || !tree.below(vertex.node, ankle)) continue;
    flesh.push_back(vertex.position - tree.at(ankle));
    sum += flesh.back();
  }
  if (flesh.empty()) return {};
  const Vec3d middle = sum * (1.0 / static_cast<double>(flesh.size()));
  const Vec3d way = normalized(across(middle, shank), {});
  double ahead = 0.0;
  double behind = 0.0;
  for (const Vec3d& p : flesh) {
    ahead = max(ahead, dot(p, way));
    behind = max(behind, -dot(p, way));
  }
  return {middle, ahead > kClearly * behind};
}

bool has_word(const SkeletonTree& tree, int i, std::span<const std::string_view> list) {
  const std::vector<std::string> words = words_of(tree.node(i).name);
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word) { return contains(list, word); });
}

// Evidence of one body for the facing direction of its names' left and right: each sign is +1 for
// it, -1 against it, 0 without evidence.
class Signs {
 public:
  Signs(const SkeletonTree& tree, const HumanoidMap& map) : tree_(tree), map_(map) {
    left_ = normalized(at(Bone::left_upper_leg) - at(Bone::right_upper_leg), {}) +
            normalized(at(Bone::left_upper_arm) - at(Bone::right_upper_arm), {});
    trunk_ = normalized(mid(Bone::left_upper_arm, Bone::right_upper_arm) -
                        mid(Bone::left_upper_leg, Bone::right_upper_leg));
  }

  [[nodiscard]] int feet() const {
    double ahead = 0.0;
    double scale = 0.0;
    for (const Side side : kBothSides) {
      const auto& [hip, knee, ankle] = leg_bones(side);
      const Vec3d foot = foot_from(tree_, map_[knee], map_[ankle]);
      const Vec3d shank = at(knee) - at(ankle);
      ahead += dot(foot, cross(left_of_hips(), shank));
      scale += norm(foot) * norm(left_of_hips()) * norm(shank);
    }
    constexpr double kClearly = 0.3;
    return abs(ahead) <= kClearly * scale ? 0 : ahead > 0.0 ? 1 : -1;
  }

  // Weighted sum of the lesser signs; two of them weigh as much as a face.
  [[nodiscard]] int others() const {
    return 2 * face() + head_mesh() + bends() + thumbs() + ornaments();
  }

 private:
  [[nodiscard]] const Vec3d& at(Bone bone) const { return tree_.at(map_[bone]); }
  [[nodiscard]] Vec3d mid(Bone a, Bone b) const { return (at(a) + at(b)) * 0.5; }
  [[nodiscard]] Vec3d left_of_hips() const {
    return at(Bone::left_upper_leg) - at(Bone::right_upper_leg);
  }

  // Sign of a direction, with `up` as the upward direction.
  [[nodiscard]] int side_of(const Vec3d& v, const Vec3d& up, double clearly = 0.4) const {
    const double ahead = dot(v, normalized(cross(left_, up), {}));
    return abs(ahead) <= clearly * norm(v) ? 0 : ahead > 0.0 ? 1 : -1;
  }

  [[nodiscard]] int face() const {
    const int head = map_[Bone::head];
    Vec3d sum{};
    for (int i = head + 1; head >= 0 && i < tree_.size(); ++i) {
      if (tree_.below(i, head) && has_word(tree_, i, kFace)) sum += tree_.at(i) - tree_.at(head);
    }
    return side_of(sum, trunk_);
  }

  [[nodiscard]] int head_mesh() const {
    constexpr double kClearly = 0.15;  // of the head's depth, its middle from its joint
    const Vec3d ahead = normalized(cross(left_, trunk_), {});
    double front = -1e300;
    double back = 1e300;
    for (const SkinVertex& vertex : tree_.skin()) {
      if (vertex.node < 0 || vertex.node != map_[Bone::head] || vertex.rigid) continue;
      const double depth = dot(vertex.position - at(Bone::head), ahead);
      front = max(front, depth);
      back = min(back, depth);
    }
    if (!(front > back)) return 0;
    const double middle = 0.5 * (front + back);
    return abs(middle) <= kClearly * (front - back) ? 0 : middle > 0.0 ? 1 : -1;
  }

  // Sign from knees ahead of their legs and elbows behind their arms, all together.
  [[nodiscard]] int bends() const {
    constexpr double kBent = 0.015;  // of the limb, from its line
    int sum = 0;
    for (std::size_t limb = 0; limb < kLimbBones.size(); ++limb) {
      const auto& [upper, lower, end] = kLimbBones[limb];
      const Vec3d line = at(end) - at(upper);
      const Vec3d off = across(at(lower) - at(upper), normalized(line));
      if (norm(off) <= kBent * norm(line)) continue;
      sum += side_of(off, limb < 2 ? at(upper) - at(end) : trunk_, 0.7) * (limb < 2 ? 1 : -1);
    }
    return std::clamp(sum, -1, 1);
  }

  [[nodiscard]] int thumbs() const {
    const auto is_thumb = [&](int i) {
      return read_bone_name(tree_.node(i).name).part == BonePart::thumb;
    };
    Vec3d sum{};
    for (const Side side : kBothSides) {
      const int hand = map_[arm_bones(side)[2]];
      const Vec3d along = normalized(tree_.at(tree_.farthest(hand, is_thumb)) - tree_.at(hand), {});
      for (int i = hand + 1; i < tree_.size(); ++i) {
        if (!tree_.below(i, hand) || !is_thumb(i)) continue;
        sum += normalized(across(tree_.at(i) - tree_.at(hand), along), {});
      }
    }
    return side_of(sum, trunk_, 0.6);
  }

  [[nodiscard]] int ornaments() const {
    const Vec3d from = mid(Bone::left_upper_leg, Bone::right_upper_leg);
    Vec3d sum{};
    for (int i = 0; i < tree_.size(); ++i) {
      if (!tree_.below(i, map_[Bone::hips])) continue;
      const Vec3d off = across(tree_.at(i) - from, trunk_);
      if (has_word(tree_, i, kFront)) sum += off;
      if (has_word(tree_, i, kBack)) sum += -off;
    }
    return side_of(sum, trunk_);
  }

  const SkeletonTree& tree_;
  const HumanoidMap& map_;
  Vec3d left_{};
  Vec3d trunk_{};
};

}  // namespace

int foot_tip(const SkeletonTree& tree, int knee, int ankle) {
  const auto part = [&](int i) { return read_bone_name(tree.node(i).name).part; };
  const auto is_heel = [&](int i) { return part(i) == BonePart::heel; };
  const int tip = tree.farthest(ankle, is_heel);
  int toes = -1;
  for (int i = ankle + 1; i < tree.size(); ++i) {
    if (!tree.below(i, ankle) || part(i) != BonePart::toes) continue;
    if (tree.below(tip, i)) return tip;
    if (toes < 0) toes = i;
  }
  if (toes >= 0) return tree.farthest(toes);
  if (is_heel(ankle)) return ankle;
  const FootMesh mesh = foot_mesh(tree, knee, ankle);
  const Vec3d shank = normalized(tree.at(knee) - tree.at(ankle));
  const Vec3d foot = across(tree.at(tip) - tree.at(ankle), shank);
  constexpr double kAgainst = -0.5;  // cosine of 120°
  const Vec3d flesh = across(mesh.middle, shank);
  const bool is_behind = dot(foot, flesh) < kAgainst * norm(foot) * norm(flesh);
  return mesh.clear && is_behind ? ankle : tip;
}

Vec3d foot_from(const SkeletonTree& tree, int knee, int ankle) {
  const int tip = foot_tip(tree, knee, ankle);
  return tip != ankle ? tree.at(tip) - tree.at(ankle) : foot_mesh(tree, knee, ankle).middle;
}

bool is_mirrored(const SkeletonTree& tree, const HumanoidMap& map) {
  const Signs signs(tree, map);
  constexpr int kFaceAndAnother = 3;
  const int feet = signs.feet();
  if (feet > 0) return false;
  const int others = signs.others();
  return feet < 0 ? others <= 0 : others <= -kFaceAndAnother;
}

}  // namespace shigusa
