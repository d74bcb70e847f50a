// SPDX-License-Identifier: MIT
#include "limb_ends.hpp"

#include <fmt/format.h>

#include <shigusa/human.hpp>

#include "body/anthropometry.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "formats/gltf_nodes.hpp"
#include "human/landmark_points.hpp"
#include "math/linear_map.hpp"
#include "rig/find_humanoid.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

// Share of the forearm in the length beyond an elbow, and of the shank in that beyond a knee.
constexpr double kForearm = F::kForearm / (F::kForearm + F::kHand);
constexpr double kShank = F::kShank / (F::kShank + F::kAnkleHeight);
// Fewest vertices that determine an end.
constexpr int kFewest = 12;

// (nodes) end of the mesh of a joint without children; empty for all others.
std::vector<std::optional<Vec3d>> mesh_ends(const Skeleton& skeleton,
                                            const std::vector<Transformd>& world,
                                            std::span<const SkinVertex> skin) {
  const std::size_t count = skeleton.nodes.size();
  std::vector<bool> leaf(count, true);
  for (const SkeletonNode& node : skeleton.nodes) {
    if (node.parent >= 0) leaf[index(node.parent)] = false;
  }
  std::vector<Vec3d> sum(count);
  std::vector<int> vertices(count, 0);
  for (const SkinVertex& vertex : skin) {
    if (vertex.node < 0) continue;
    sum[index(vertex.node)] += vertex.position - world[index(vertex.node)].translation;
    ++vertices[index(vertex.node)];
  }
  std::vector<double> reach(count, 0.0);
  for (const SkinVertex& vertex : skin) {
    if (vertex.node < 0) continue;
    const auto i = index(vertex.node);
    const Vec3d off = vertex.position - world[i].translation;
    reach[i] = max(reach[i], dot(off, normalized(sum[i], {})));
  }
  std::vector<std::optional<Vec3d>> ends(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!leaf[i] || vertices[i] < kFewest || !(reach[i] > 0.0)) continue;
    ends[i] = world[i].translation + normalized(sum[i]) * reach[i];
  }
  return ends;
}

// Transforms a point of the world to a node's frame, including scales.
std::optional<Vec3d> in_node(const GltfCharacter& file, int node, const Vec3d& point) {
  std::vector<int> way;
  for (int i = node; i >= 0; i = file.rest.skeleton.nodes[index(i)].parent) way.push_back(i);
  Vec3d p = point;
  for (auto i = way.rbegin(); i != way.rend(); ++i) {
    const Transformd place = file.places[index(*i)].transform();
    const std::optional<Mat3d> back = inverse_of(place.rotation);
    if (!back) return std::nullopt;
    p = *back * (p - place.translation);
  }
  return p;
}

// The skeleton with a tip node for each terminal joint with a mesh, and its person's bone map.
struct LongerSkeleton {
  std::vector<Transformd> world;  // (nodes) the file's own, then the tips
  std::vector<int> joint;         // (added nodes) parent of each
  HumanoidMap map;

  // The file's own node of a bone, or the parent of an added one.
  [[nodiscard]] int own(HumanoidBone bone) const {
    const auto count = static_cast<int>(world.size() - joint.size());
    return map[bone] < count ? map[bone] : joint[index(map[bone] - count)];
  }
};

std::optional<LongerSkeleton> lengthened(const GltfCharacter& file,
                                         const std::vector<Transformd>& world,
                                         std::span<const SkinVertex> skin) {
  Skeleton skeleton = file.rest.skeleton;
  LongerSkeleton longer{world, {}, {}};
  const auto ends = mesh_ends(skeleton, world, skin);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!ends[i]) continue;
    skeleton.nodes.push_back({fmt::format("{}_end", skeleton.nodes[i].name), static_cast<int>(i),
                              *ends[i] - world[i].translation});
    longer.world.push_back({Mat3d{}, *ends[i]});
    longer.joint.push_back(static_cast<int>(i));
  }
  Result<HumanoidMap> map = find_humanoid(skeleton, longer.world, file.humanoid, {}, skin);
  if (!map) return {};
  longer.map = std::move(*map);
  return longer;
}

// Position of the missing end as a share of the length from its joint to the end of the mesh; the
// other side's share if that has a node of the file.
double share_of(const LongerSkeleton& longer, std::size_t limb, double length) {
  const auto& [upper, lower, end] = kLimbBones[limb ^ 1];
  const int node = longer.own(end);
  const int joint = longer.map[lower];
  const double usual = limb < 2 ? kShank : kForearm;
  if (node == joint || !(length > 0.0)) return usual;
  const double fellow =
      norm(longer.world[index(node)].translation - longer.world[index(joint)].translation) / length;
  constexpr double kShortest = 0.3;
  constexpr double kLongest = 0.95;
  return fellow > kShortest && fellow < kLongest ? fellow : usual;
}

// Node for the end of a limb whose last joint has no child; empty for any other limb.
std::optional<GltfNewNode> missing_end(const GltfCharacter& file, const LongerSkeleton& longer,
                                       std::size_t limb) {
  const auto& [upper, lower, end] = kLimbBones[limb];
  const int joint = longer.map[lower];
  if (longer.own(end) != joint) return {};
  const Vec3d& from = longer.world[index(joint)].translation;
  const Vec3d& tip = longer.world[index(longer.map[end])].translation;
  const double share = share_of(longer, limb, norm(tip - from));
  const auto wrist = in_node(file, joint, from + (tip - from) * share);
  const auto beyond = in_node(file, joint, tip);
  if (!wrist || !beyond) return {};
  GltfNewNode added{file.file_node[index(joint)], std::string(humanoid_bone_name(end)), *wrist, {}};
  if (limb >= 2) added.tip = *beyond - *wrist;
  return added;
}

}  // namespace

std::optional<EndedFile> with_limb_ends(const std::string& bytes, const std::string& name,
                                        const GltfCharacter& file,
                                        std::span<const SkinVertex> skin) {
  const SkeletonMotion& rest = file.rest;
  const std::vector<Transformd> world = world_transforms(rest.skeleton, rest.clip, 0);
  if (skin.empty() || find_humanoid(rest.skeleton, world, file.humanoid, {}, skin)) return {};
  const std::optional<LongerSkeleton> longer = lengthened(file, world, skin);
  if (!longer) return {};
  EndedFile ended;
  std::vector<GltfNewNode> added;
  for (std::size_t limb = 0; limb < kLimbBones.size(); ++limb) {
    std::optional<GltfNewNode> node = missing_end(file, *longer, limb);
    if (!node) continue;
    const int joint = longer->map[kLimbBones[limb][1]];
    ended.doubts.push_back(say("limb_ends_at", rest.skeleton.nodes[index(joint)].name, node->name));
    added.push_back(std::move(*node));
  }
  if (added.empty()) return {};
  Result<std::string> longer_bytes = add_nodes(bytes, name, added);
  if (!longer_bytes) return {};
  ended.bytes = std::move(*longer_bytes);
  return ended;
}

}  // namespace shigusa
