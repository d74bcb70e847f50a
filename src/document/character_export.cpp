// SPDX-License-Identifier: MIT
#include "character_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/files.hpp>
#include <shigusa/formats.hpp>
#include <shigusa/motion.hpp>

#include "character/character_rig.hpp"
#include "core/say.hpp"
#include "formats/gltf_write.hpp"
#include "glb_things.hpp"
#include "hand_play.hpp"
#include "in_place.hpp"
#include "measure/measure_person.hpp"

namespace shigusa {
namespace {

// VRM 1.0 names of the bones that a motion of the body may turn; parents before children.
constexpr std::array<std::string_view, 22> kVrmBones{
    "hips",          "spine",         "chest",         "upperChest",    "neck",
    "head",          "leftShoulder",  "leftUpperArm",  "leftLowerArm",  "leftHand",
    "rightShoulder", "rightUpperArm", "rightLowerArm", "rightHand",     "leftUpperLeg",
    "leftLowerLeg",  "leftFoot",      "leftToes",      "rightUpperLeg", "rightLowerLeg",
    "rightFoot",     "rightToes"};

bool same(const Vec3d& a, const Vec3d& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
bool same(const Quatd& a, const Quatd& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}

// Animation of a rig with rest transforms `rest` (nodes): tracks of the nodes that move, and of
// those whose first frame differs from rest.
GltfAnimation animation_of(const Rig& rig, const std::vector<GltfPlace>& rest,
                           const RigMotion& motion, const std::string& name) {
  GltfAnimation animation{name, motion.frame_time, motion.frames, {}};
  const std::size_t nodes = rig.nodes.size();
  const auto frames = static_cast<std::size_t>(motion.frames);
  for (std::size_t i = 0; i < nodes; ++i) {
    const RigNode& node = rig.nodes[i];
    const bool turns = motion.turns[i] || !same(node.rotation, rest[i].rotation);
    const bool moves = motion.moves[i] || !same(node.translation, rest[i].translation);
    const bool scaled = !same(node.scale, rest[i].scale);
    if (!turns && !moves && !scaled) continue;
    GltfTrack& track = animation.tracks.emplace_back();
    track.node = static_cast<int>(i);
    track.rest = rest[i];
    for (std::size_t f = 0; f < frames; ++f) {
      const LocalTransform& local = motion.local[f * nodes + i];
      if (turns) track.rotations.push_back(local.rotation);
      if (moves) track.translations.push_back(local.translation);
    }
    if (scaled) track.scales.assign(frames, node.scale);
  }
  return animation;
}

// The character's rig with all rest rotations removed.
Rig unturned(const CharacterRig& character) {
  Rig result = character.rig;
  for (std::size_t i = 0; i < result.nodes.size(); ++i) {
    RigNode& node = result.nodes[i];
    node = {node.parent, character.posed[i].translation, character.posed[i].rotation};
  }
  return result;
}

// The character's VRM bones as a separate skeleton, parents first.
class VrmSkeleton {
 public:
  VrmSkeleton(const CharacterRig& character, bool fingers) : character_(character) {
    rig = character.rig;
    rig.nodes.clear();
    const std::vector<Vec3d> at = rest_origins(character.skeleton);
    const std::vector<Transformd> posed =
        world_transforms(character.skeleton, {0.0, 1, character.posed}, 0);
    std::vector<int> ours(character.skeleton.nodes.size(), -1);
    // in the file's order: its bones may have a different hierarchy than VRM requires
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const std::string name = vrma_bone(character, static_cast<int>(i), fingers);
      if (name.empty()) continue;
      int above = character.skeleton.nodes[i].parent;
      while (above >= 0 && ours[static_cast<std::size_t>(above)] < 0) {
        above = character.skeleton.nodes[static_cast<std::size_t>(above)].parent;
      }
      const int parent = above < 0 ? -1 : ours[static_cast<std::size_t>(above)];
      // a VRM animation has one root
      if (parent < 0 && !bones.empty()) beside = character.skeleton.nodes[i].name;
      ours[i] = static_cast<int>(bones.size());
      const Vec3d offset = above < 0 ? at[i] : at[i] - at[static_cast<std::size_t>(above)];
      bones.push_back({name, parent, facing_ahead(offset)});
      rest.push_back({bones.back().offset});
      const Transformd from = above < 0 ? Transformd{} : posed[static_cast<std::size_t>(above)];
      const Transformd local = inverse(from) * posed[i];
      rig.nodes.push_back(
          {parent, facing_ahead(local.translation), facing_ahead(to_quat(local.rotation))});
    }
    for (int& node : rig.bones.node) {
      if (node >= 0) node = ours[static_cast<std::size_t>(node)];
    }
    for (int& node : rig.grips) {
      if (node >= 0) node = ours[static_cast<std::size_t>(node)];
    }
    for (FingerBone& finger : rig.fingers) {
      finger.node = ours[static_cast<std::size_t>(finger.node)];
      finger.axis = facing_ahead(finger.axis);
    }
    std::erase_if(rig.fingers, [](const FingerBone& finger) { return finger.node < 0; });
    rig.twists.clear();  // twist bones are not part of VRM
    Placement& p = rig.placement;
    for (Vec3d* v : {&p.left, &p.up, &p.ahead, &p.origin}) *v = facing_ahead(*v);
  }

  std::string beside;  // a second root bone; empty: none
  std::vector<VrmAnimation::Bone> bones;
  std::vector<GltfPlace> rest;  // (bones)
  Rig rig;                      // rig of these bones in their poses

 private:
  // Turns a vector about, as VRM animations face +Z and characters of VRM 0.x face -Z.
  [[nodiscard]] Vec3d facing_ahead(const Vec3d& v) const {
    return character_.ahead.z < 0.0 ? Vec3d{-v.x, v.y, -v.z} : v;
  }
  [[nodiscard]] Quatd facing_ahead(const Quatd& q) const {
    return character_.ahead.z < 0.0 ? Quatd{-q.x, q.y, -q.z, q.w} : q;
  }

  const CharacterRig& character_;
};

}  // namespace

std::vector<LocalTransform> node_motion(const CharacterSpec& character, const Task& task,
                                        const Candidate& candidate, const Clip& clip,
                                        MotionPlace place) {
  if (!character.rig) return node_motion(character, static_cast<const PosedBody&>(task), clip);
  return rig_motion(task, clip, character.rig->rig, hand_play(task, candidate),
                    place == MotionPlace::file)
      .local;
}

std::string vrma_bone(const CharacterRig& character, int node, bool fingers) {
  for (const auto& [name, at] : character.vrm_bones) {
    const auto known = std::find(kVrmBones.begin(), kVrmBones.end(), name);
    if (at == node && known != kVrmBones.end()) return name;
  }
  if (!fingers) return {};
  for (const FingerBone& finger : character.rig.fingers) {
    // also for VRM 0.x, whose thumb bones have other names
    if (finger.node == node) return vrm_finger_name(finger);
  }
  return {};
}

std::string candidate_animation(const CharacterSpec& character, std::size_t rank) {
  return free_animation(character, fmt::format("shigusa candidate {}", rank));
}

std::string free_animation(const CharacterSpec& character, const std::string& plain) {
  if (!character.rig) return plain;
  const auto& taken = character.rig->animations;
  std::string name = plain;
  for (int k = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++k) {
    name = fmt::format("{} ({})", plain, k);
  }
  return name;
}

RigMotion CharacterExporter::motion_of(const PosedBody& body, const Clip& clip, const Rig& rig,
                                       const HandPlay& hands) const {
  RigMotion motion = rig_motion(body, clip, rig, hands);
  if (settings_.in_place) stay_in_place(rig, motion);
  return motion;
}

std::string CharacterExporter::bvh(const PosedBody& body, const Clip& clip,
                                   const HandPlay& hands) const {
  const bool own = character_.format == FileFormat::bvh;
  const Rig rig = own ? character_.rig : unturned(character_);
  const RigMotion moved = motion_of(body, clip, rig, hands);
  const double unit = rig.placement.unit;
  SkeletonMotion motion{character_.skeleton, {moved.frame_time, moved.frames, moved.local}};
  for (SkeletonNode& node : motion.skeleton.nodes) node.offset = node.offset * unit;
  for (LocalTransform& local : motion.clip.local) local.translation = local.translation * unit;
  if (!own) return format_bvh(motion);
  return format_bvh(motion, {.unit = unit, .channels = character_.channels});
}

GltfAnimation CharacterExporter::animation(const PosedBody& body, const Clip& clip,
                                           const std::string& name,
                                           const MotionExtras& extras) const {
  const Rig& rig = character_.rig;
  RigMotion motion = rig_motion(body, clip, rig, extras.hands);
  const auto kept = settings_.in_place ? stay_in_place(rig, motion) : std::vector<Vec3d>{};
  GltfAnimation animation = animation_of(rig, character_.places, motion, name);
  animation.things = things_in_file(extras.things, rig.placement, kept);
  animation.markers = extras.markers;
  for (GltfTrack& track : animation.tracks) {
    track.node = character_.file_node[static_cast<std::size_t>(track.node)];
  }
  return animation;
}

Result<std::string> CharacterExporter::glb(std::span<const GltfAnimation> animations) const {
  const OwnAnimations own =
      settings_.only_this_clip ? OwnAnimations::left_out : OwnAnimations::kept;
  return add_animations(*character_.bytes, character_.file.filename().string(), animations, own);
}

Result<std::string> CharacterExporter::vrma(const PosedBody& body, const Clip& clip,
                                            const std::string& name,
                                            const MotionExtras& extras) const {
  VrmSkeleton skeleton(character_, extras.hands.fingers);
  if (!skeleton.beside.empty()) {
    return fail(ErrorCode::unsupported, say("vrma_one_root", skeleton.beside), "the format vrma");
  }
  const RigMotion motion = motion_of(body, clip, skeleton.rig, extras.hands);
  GltfAnimation animation = animation_of(skeleton.rig, skeleton.rest, motion, name);
  animation.markers = extras.markers;
  // bone lengths are constant: of the VRM bones only the hips translate
  for (GltfTrack& track : animation.tracks) {
    if (track.node > 0) track.translations.clear();
  }
  std::erase_if(animation.tracks, [](const GltfTrack& track) {
    return track.rotations.empty() && track.translations.empty();
  });
  return format_vrm_animation({std::move(skeleton.bones), std::move(animation)});
}

double bvh_unit(const CharacterSpec& spec) {
  const bool own = spec.rig && spec.rig->format == FileFormat::bvh;
  return own ? spec.rig->rig.placement.unit : BvhFormat{}.unit;
}

}  // namespace shigusa
