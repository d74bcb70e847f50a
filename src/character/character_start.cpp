// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "body/anthropometry.hpp"
#include "character_file.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "formats/gltf_animation.hpp"
#include "formats/gltf_skin.hpp"
#include "human/landmark_points.hpp"
#include "human/stance.hpp"
#include "humanoid_request.hpp"
#include "rig/find_humanoid.hpp"
#include "rig/finger_bones.hpp"
#include "start_frame.hpp"

namespace shigusa {
namespace {

// Moves the person vertically until the lower sole of a person of that stature is on the floor.
void stand_on_floor(MeasuredPerson& measured, double stature) {
  Landmarks& person = measured.landmarks;
  double floor = 1e9;
  for (const Side side : kBothSides) {
    const Landmarks::Leg& leg = person.leg(side);
    const double by_joints = min(leg.ankle.y - StatureFractions::kAnkleHeight * stature, leg.toe.y);
    floor = min(floor, leg.sole ? (*leg.sole)[0].y : by_joints);
  }
  for_each_point(person, [&](Vec3d& p) { p.y -= floor; });
  measured.placement.origin += measured.placement.up * (floor / measured.placement.unit);
}

// The person in a frame of an animation, with the unit and stature of the rest pose, since
// measuring along the bones of a bent trunk gives a different person.
Result<MeasuredPerson> measure_posed(const Skeleton& skeleton, const SkeletonClip& clip, int frame,
                                     std::span<const SkinVertex> skin, const PersonStart& found) {
  const MeasuredPerson& rest = found.person;
  const std::vector<Transformd> world = world_transforms(skeleton, clip, frame);
  const auto measured = [&](double stature) {
    return measure_person(skeleton, world, found.map, {.stature = stature, .skin = skin});
  };
  SHG_TRY_ASSIGN(const MeasuredPerson bent, measured(rest.stature));
  SHG_TRY_ASSIGN(MeasuredPerson posed,
                 measured(rest.stature * rest.placement.unit / bent.placement.unit));
  stand_on_floor(posed, rest.stature);
  // limb shapes are measured at rest, with straight limbs and the undeformed mesh
  posed.landmarks.parts = rest.landmarks.parts;
  posed.landmarks.trunk_lean = rest.landmarks.trunk_lean;
  return posed;
}

FilePose pose_at(const CharacterFile& file, int frame) {
  const LocalTransform* local = file.motion.frame(file.skeleton, frame);
  return {{local, local + file.skeleton.nodes.size()}, file.posed};
}

// Fits the shapes of hands that have one again, with the fingers in a relaxed grip.
void fit_hands(const CharacterFile& file, const std::vector<Transformd>& world,
               const HumanoidMap& map, std::span<const SkinVertex> skin, MeasuredPerson& person) {
  const std::vector<FingerBone> fingers =
      find_finger_bones(file.skeleton, world, map, file.rig.vrm_bones, person.placement.mirrored());
  if (skin.empty() || fingers.empty()) return;
  const std::vector<SkinVertex> hands = relaxed_hands(file.skeleton, world, map, fingers, skin);
  const PartShapes fitted = fitted_hands(file.skeleton, world, hands, map, person);
  for (const BodyPart hand : {BodyPart::left_hand, BodyPart::right_hand}) {
    std::optional<PartShape>& shape = person.landmarks.parts[hand];
    if (shape && fitted[hand]) shape = fitted[hand];
  }
}

// Finds the bones of a file in one pose with the mesh `skin`, and measures the person.
Result<PersonStart> measure_in(const CharacterFile& file, const CharacterSpec& spec,
                               const FilePose& pose, std::span<const SkinVertex> skin,
                               bool at_rest) {
  const std::vector<Transformd> world = world_transforms(file.skeleton, pose.clip(), 0);
  std::vector<std::string> nodes;
  for (const SkeletonNode& node : file.skeleton.nodes) nodes.push_back(node.name);
  SHG_TRY_ASSIGN(const HumanoidMap asked,
                 requested_bones(spec.map, nodes, spec.source, file.rig.file_node));
  SHG_TRY_ASSIGN(
      const HumanoidMap map,
      find_humanoid(file.skeleton, world, file.given, asked, skin).map_error(within(spec.source)));
  SHG_TRY_ASSIGN(MeasuredPerson person,
                 measure_person(file.skeleton, world, map,
                                {.stature = spec.stature, .skin = skin, .at_rest = at_rest})
                     .map_error(within(spec.source)));
  SHG_TRY(check_likeness(person.landmarks, spec.map, spec.source));
  fit_hands(file, world, map, skin, person);
  return PersonStart{map, pose, person, pose, person};
}

bool rests(const PersonStart& person) {
  return stands_at_rest(person.person.landmarks, person.person.stature);
}

// Measures glTF at rest, where no animation obscures the bones: in the nodes' own pose, or, if that
// is a pose amid a motion, in the mesh's bind pose.
Result<PersonStart> measure_at_rest(const CharacterFile& file, const CharacterSpec& spec) {
  Result<PersonStart> person = measure_in(file, spec, file.rest, file.skin, true);
  if (!file.bound || (person && rests(*person))) return person;
  Result<PersonStart> bound = measure_in(file, spec, *file.bound, file.bound_skin, true);
  if (!bound || !rests(*bound)) return person;
  bound->start.doubts.push_back(say("bind_pose"));
  return bound;
}

// First animation of a file that begins with a standing person, or "".
std::string standing_animation(const CharacterFile& file, const PersonStart& found) {
  constexpr std::size_t kTried = 6;
  constexpr double kSlowly = 1.0;  // Hz: only the first frame is examined
  const std::vector<std::string>& names = file.rig.animations;
  for (std::size_t i = 0; i < std::min(names.size(), kTried); ++i) {
    const Result<GltfMotion> moving = parse_gltf_animation(
        *file.rig.bytes, file.rig.file.string(), {.animation = names[i], .frame_rate = kSlowly});
    if (!moving) continue;
    const Result<MeasuredPerson> posed =
        measure_posed(file.skeleton, moving->motion.clip, 0, {}, found);
    if (posed && stands_at_rest(posed->landmarks, found.person.stature)) return names[i];
  }
  return {};
}

// The person of a glTF file in a frame of its animation; `file` has the requested frame's pose.
Result<PersonStart> in_animation(const CharacterFile& file, const CharacterSpec& spec,
                                 const PersonStart& rest, int frame) {
  FilePose pose = pose_at(file, frame);
  std::vector<SkinVertex> skin = file.posed_skin;
  if (frame != spec.frame.value_or(0)) {
    const std::string& bytes = *file.rig.bytes;
    SHG_TRY_ASSIGN(const GltfMotion moving,
                   parse_gltf_animation(
                       bytes, spec.source,
                       {.animation = spec.animation.value_or(""), .posed = frame, .gaps = true}));
    pose.places = moving.posed;
    skin = read_gltf_skin(bytes, spec.source, moving.character, moving.posed).vertices;
  }
  PersonStart found = rest;
  SHG_TRY_ASSIGN(
      found.start,
      measure_posed(file.skeleton, file.motion, frame, skin, rest).map_error(within(spec.source)));
  found.posed = std::move(pose);
  return found;
}

// The person in the file's own pose, if that differs from the mesh's bind pose and shows a person
// who stands still on both feet without the spread arms of a modelling pose.
std::optional<PersonStart> in_own_pose(const CharacterFile& file, const CharacterSpec& spec) {
  if (!file.bound || spec.frame || spec.seat) return std::nullopt;
  Result<PersonStart> found = measure_in(file, spec, *file.bound, file.bound_skin, true);
  if (!found || !rests(*found)) return std::nullopt;
  Result<MeasuredPerson> own = measure_posed(file.skeleton, file.rest.clip(), 0, file.skin, *found);
  CharacterFile shown;
  shown.skeleton = file.skeleton;
  shown.motion = file.rest.clip();
  shown.rig.format = file.rig.format;
  if (!own || !begins_standing(shown, spec, *found)) return std::nullopt;
  found->start = std::move(*own);
  found->posed = file.rest;
  found->start.doubts.push_back(say("own_pose"));
  return std::move(*found);
}

// Frames in which a bone of the person, or an ancestor of it, is unknown.
std::vector<int> unknown_frames(const CharacterFile& file, const HumanoidMap& map) {
  std::vector<bool> carries(file.skeleton.nodes.size(), false);
  for (const HumanoidBone bone : kHumanoidBones) {
    for (int i = map[bone]; i >= 0; i = file.skeleton.nodes[index(i)].parent) {
      carries[index(i)] = true;
    }
  }
  std::set<int> frames;
  for (const GltfGap& gap : file.gaps) {
    for (int f = gap.first; carries[index(gap.node)] && f <= gap.last; ++f) frames.insert(f);
  }
  return {frames.begin(), frames.end()};
}

Result<PersonStart> find_in_gltf(CharacterFile& file, const CharacterSpec& spec) {
  SHG_TRY_ASSIGN(PersonStart rest, measure_at_rest(file, spec));
  if (!file.gaps.empty()) file.unread_frames = unknown_frames(file, rest.map);
  const bool known = index(file.motion.frames) > file.unread_frames.size();
  if (file.motion.frames > 0 && (known || spec.frame)) {
    SHG_TRY_ASSIGN(const std::optional<int> frame, frame_of(file, spec));
    const auto at_rest = [&]() -> Result<PersonStart> {
      PersonStart eased = rest;
      eased.eased = true;
      return eased;
    };
    return choose_start(file, spec, rest, *frame,
                        {[&](int at) { return in_animation(file, spec, rest, at); }, at_rest});
  }
  if (std::optional<PersonStart> own = in_own_pose(file, spec)) return std::move(*own);
  rest.eased = true;
  if (rests(rest)) return rest;
  const std::string better = standing_animation(file, rest);
  rest.start.doubts.push_back(
      say("not_standing", better.empty() ? "" : say("standing_animation", better)));
  return rest;
}

Result<PersonStart> find_in_bvh(const CharacterFile& file, const CharacterSpec& spec) {
  const auto at_rest = [&] {
    Result<PersonStart> found = measure_in(file, spec, file.rest, {}, true);
    if (found) found->eased = true;
    return found;
  };
  if (spec.frame == kRestPose) return at_rest();
  SHG_TRY_ASSIGN(const std::optional<int> frame, frame_of(file, spec));
  if (!frame) {
    Result<PersonStart> found = at_rest();
    if (found) {
      found->frame = kRestPose;
      found->start.doubts.push_back(say("no_motion"));
    }
    return found;
  }
  const auto in_frame = [&](int at) {
    return measure_in(file, spec, pose_at(file, at), {}, false);
  };
  Result<PersonStart> known = in_frame(*frame);
  if (known && !spec.frame && spreads_arms(known->person.landmarks)) {
    known = measure_in(file, spec, pose_at(file, *frame), {}, true);
    if (!known) return known;
    known->eased = true;
    return known;
  }
  // the facing direction of a person lying sideways is undetermined
  if (!known && !spec.frame) {
    const Result<PersonStart> rest = at_rest();
    if (rest) known = rest;
  }
  if (!known) return known;
  return choose_start(file, spec, *known, *frame, {in_frame, at_rest});
}

}  // namespace

Result<PersonStart> find_person(CharacterFile& file, const CharacterSpec& spec) {
  return file.rig.format == FileFormat::bvh ? find_in_bvh(file, spec) : find_in_gltf(file, spec);
}

}  // namespace shigusa
