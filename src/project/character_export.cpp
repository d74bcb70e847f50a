// SPDX-License-Identifier: MIT
#include "character_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace shigusa {
namespace {

// Bones that a motion of the body may turn, as VRM 1.0 names them; parents before children.
constexpr std::array<std::string_view, 22> kVrmBones{
    "hips",          "spine",         "chest",         "upperChest",    "neck",
    "head",          "leftShoulder",  "leftUpperArm",  "leftLowerArm",  "leftHand",
    "rightShoulder", "rightUpperArm", "rightLowerArm", "rightHand",     "leftUpperLeg",
    "leftLowerLeg",  "leftFoot",      "leftToes",      "rightUpperLeg", "rightLowerLeg",
    "rightFoot",     "rightToes"};

GltfTrack track_of(const RigMotion& motion, std::size_t nodes, std::size_t node) {
  GltfTrack track;
  for (int f = 0; f < motion.frames; ++f) {
    const LocalTransform& local = motion.local[static_cast<std::size_t>(f) * nodes + node];
    if (motion.turns[node]) track.rotations.push_back(local.rotation);
    if (motion.moves[node]) track.translations.push_back(local.translation);
  }
  return track;
}

GltfAnimation animation_of(const Rig& rig, const RigMotion& motion, const std::string& name) {
  GltfAnimation animation{name, motion.frame_time, motion.frames, {}};
  for (std::size_t i = 0; i < rig.nodes.size(); ++i) {
    if (!motion.turns[i] && !motion.moves[i]) continue;
    animation.tracks.push_back(track_of(motion, rig.nodes.size(), i));
    animation.tracks.back().node = static_cast<int>(i);
    animation.tracks.back().rest = {rig.nodes[i].translation, rig.nodes[i].rotation,
                                    rig.nodes[i].scale};
  }
  return animation;
}

// The same rig with other nodes, none of them turned at rest.
Rig unturned(const Rig& rig, const Skeleton& skeleton) {
  Rig result = rig;
  result.nodes.clear();
  for (const SkeletonNode& node : skeleton.nodes) {
    result.nodes.push_back({node.parent, node.offset, {}});
  }
  return result;
}

// The character's VRM bones as a skeleton of their own, parents first.
class VrmSkeleton {
 public:
  explicit VrmSkeleton(const CharacterRig& character) : character_(character) {
    rig = character.rig;
    rig.nodes.clear();
    const std::vector<Vec3d> at = rest_origins(character.skeleton);
    std::vector<int> ours(character.skeleton.nodes.size(), -1);
    // by the file's order: bones of a file may hang together otherwise than VRM wants them
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const std::string_view name = bone_at(static_cast<int>(i));
      if (name.empty()) continue;
      int above = character.skeleton.nodes[i].parent;
      while (above >= 0 && ours[static_cast<std::size_t>(above)] < 0) {
        above = character.skeleton.nodes[static_cast<std::size_t>(above)].parent;
      }
      const int parent = above < 0 ? -1 : ours[static_cast<std::size_t>(above)];
      // what hangs on no bone but the hips' would be a second root
      if (parent < 0 && !bones.empty()) continue;
      ours[i] = static_cast<int>(bones.size());
      const Vec3d offset = above < 0 ? at[i] : at[i] - at[static_cast<std::size_t>(above)];
      bones.push_back({std::string(name), parent, facing_ahead(offset)});
      rig.nodes.push_back({parent, bones.back().offset});
    }
    for (int& node : rig.bones.node) {
      if (node >= 0) node = ours[static_cast<std::size_t>(node)];
    }
    rig.grips = {-1, -1};  // on fingers
    Placement& p = rig.placement;
    for (Vec3d* v : {&p.left, &p.up, &p.ahead, &p.origin}) *v = facing_ahead(*v);
  }

  std::vector<VrmAnimation::Bone> bones;
  Rig rig;  // of these bones

 private:
  [[nodiscard]] std::string_view bone_at(int node) const {
    for (const auto& [name, at] : character_.vrm_bones) {
      const auto known = std::find(kVrmBones.begin(), kVrmBones.end(), name);
      if (at == node && known != kVrmBones.end()) return *known;
    }
    return {};
  }

  // VRM animations face +Z; characters of VRM 0.x face -Z.
  [[nodiscard]] Vec3d facing_ahead(const Vec3d& v) const {
    return character_.rig.placement.ahead.z < 0.0 ? Vec3d{-v.x, v.y, -v.z} : v;
  }

  const CharacterRig& character_;
};

}  // namespace

std::string animation_name(const CharacterSpec& character, std::size_t rank) {
  const std::string plain = fmt::format("shigusa candidate {}", rank);
  if (!character.rig) return plain;
  const auto& taken = character.rig->animations;
  std::string name = plain;
  for (int k = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++k) {
    name = fmt::format("{} ({})", plain, k);
  }
  return name;
}

std::string CharacterExporter::bvh(const BodyModel& body, const Clip& clip) const {
  const bool own = character_.format == CharacterFormat::bvh;
  const Rig rig = own ? character_.rig : unturned(character_.rig, character_.skeleton);
  const RigMotion moved = rig_motion(body, clip, rig);
  const double unit = rig.placement.unit;
  SkeletonMotion motion{character_.skeleton, {moved.frame_time, moved.frames, moved.local}};
  for (SkeletonNode& node : motion.skeleton.nodes) node.offset = node.offset * unit;
  for (LocalTransform& local : motion.clip.local) local.translation = local.translation * unit;
  if (!own) return format_bvh(motion);
  return format_bvh(motion, {.unit = unit, .channels = character_.channels});
}

GltfAnimation CharacterExporter::animation(const BodyModel& body, const Clip& clip,
                                           const std::string& name) const {
  GltfAnimation animation =
      animation_of(character_.rig, rig_motion(body, clip, character_.rig), name);
  for (GltfTrack& track : animation.tracks) {
    track.node = character_.file_node[static_cast<std::size_t>(track.node)];
  }
  return animation;
}

Result<std::string> CharacterExporter::glb(std::span<const GltfAnimation> animations) const {
  return add_animations(*character_.bytes, character_.file.filename().string(), animations);
}

Result<std::string> CharacterExporter::vrma(const BodyModel& body, const Clip& clip,
                                            const std::string& name) const {
  VrmSkeleton skeleton(character_);
  const RigMotion motion = rig_motion(body, clip, skeleton.rig);
  return format_vrm_animation(
      {std::move(skeleton.bones), animation_of(skeleton.rig, motion, name)});
}

double bvh_unit(const CharacterSpec& spec) {
  const bool own = spec.rig && spec.rig->format == CharacterFormat::bvh;
  return own ? spec.rig->rig.placement.unit : BvhFormat{}.unit;
}

}  // namespace shigusa
