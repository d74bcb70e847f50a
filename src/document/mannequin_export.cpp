// SPDX-License-Identifier: MIT
#include "mannequin_export.hpp"

#include <shigusa/human.hpp>

#include "core/index.hpp"
#include "glb_things.hpp"
#include "in_place.hpp"
#include "joint_names.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "mannequin_glb.hpp"

namespace shigusa {
namespace {

// One component of a node's transform in all frames; empty if it stays at rest.
template <class T>
std::vector<T> column(const std::vector<LocalTransform>& local, std::size_t node, std::size_t nodes,
                      T LocalTransform::*part, const T& rest) {
  std::vector<T> values;
  bool moves = false;
  for (std::size_t i = node; i < local.size(); i += nodes) {
    values.push_back(local[i].*part);
    moves = moves || !(local[i].*part == rest);
  }
  if (!moves) values.clear();
  return values;
}

// Skeleton with names for files; an unnamed tip is named after its parent.
Skeleton named_nodes(const Skeleton& own, JointNames names) {
  Skeleton skeleton = named(own, names);
  for (SkeletonNode& node : skeleton.nodes) {
    if (node.name.empty()) node.name = skeleton.nodes[index(node.parent)].name + "_end";
  }
  return skeleton;
}

std::vector<Vec3d> skin_of(const CharacterSpec& character, const BodyModel& body) {
  const double share = body.mass() / default_mass(body.stature(), character.sex);
  return mannequin_mesh().skin(character.sex == Sex::female, share);
}

}  // namespace

MannequinExporter::MannequinExporter(const CharacterSpec& character, const BodyModel& body,
                                     const FileSettings& settings)
    : name_(body.name()),
      mannequin_(body_skeleton(body), mannequin_mesh(), body.stature()),
      skin_(skin_of(character, body)),
      settings_(settings) {
  named_ = named_nodes(mannequin_.skeleton(), settings.names);
}

GltfAnimation MannequinExporter::animation(const PosedBody& posed, const Clip& clip,
                                           const std::string& name,
                                           const MotionExtras& extras) const {
  const std::vector<LocalTransform>& rest = mannequin_.rest();
  SkeletonClip moved = skeleton_motion(posed, clip).clip;
  std::vector<Vec3d> kept;
  if (settings_.in_place) {
    kept = stay_in_place(0, {}, {0, 1, 0}, posed.body.nodes().size(), moved.local);
  }
  const std::vector<LocalTransform> local = mannequin_.play(moved, extras.hands);
  GltfAnimation animation{name, moved.frame_time, moved.frames, {}};
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const auto& [place, turn] = rest[i];
    GltfTrack track{static_cast<int>(i), {place, turn}, {}, {}};
    track.rotations = column(local, i, rest.size(), &LocalTransform::rotation, turn);
    track.translations = column(local, i, rest.size(), &LocalTransform::translation, place);
    const bool stays = track.rotations.empty() && track.translations.empty();
    if (!stays) animation.tracks.push_back(std::move(track));
  }
  animation.things = things_in_file(extras.things, {}, kept);
  animation.markers = extras.markers;
  return animation;
}

Result<std::string> MannequinExporter::glb(std::span<const GltfAnimation> animations) const {
  return add_animations(mannequin_glb(name_, named_, mannequin_, skin_), name_, animations);
}

}  // namespace shigusa
