// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/character.hpp>
#include <shigusa/error.hpp>

#include "character_file.hpp"
#include "character_heels.hpp"
#include "character_places.hpp"
#include "character_robot.hpp"
#include "core/say.hpp"
#include "files/path.hpp"
#include "formats/file_kind.hpp"
#include "formats/nodes_glb.hpp"
#include "human/at_ease.hpp"
#include "human/landmark_points.hpp"
#include "human/segment_mass.hpp"
#include "human/stance.hpp"
#include "rig/finger_bones.hpp"

namespace shigusa {
namespace {

Result<void> check_range(const char* what, const std::optional<double>& value, double low,
                         double high, const char* unit) {
  if (!value || (*value >= low && *value <= high)) return {};
  if (std::string_view(unit) == "m") {
    return fail(ErrorCode::invalid_argument,
                say("length_out_of_range", what, Metres{*value}, Metres{low}, Metres{high}),
                "character");
  }
  return fail(ErrorCode::invalid_argument, say("out_of_range", what, *value, unit, low, high, unit),
              "character");
}

// Rig that relates the file's nodes to the measured person and their start posture.
CharacterRig make_rig(CharacterFile&& file, const PersonStart& found, const Landmarks& start) {
  CharacterRig result = std::move(file.rig);
  const MeasuredPerson& person = found.start;
  result.rig = {{}, found.map, person.grip_nodes, person.placement, person.landmarks, start};
  result.posed = found.posed.local;
  result.ahead = found.person.placement.ahead;
  result.frames = file.motion.frames;
  result.stature_guessed = found.person.stature_guessed;
  for (std::size_t i = 0; i < file.skeleton.nodes.size(); ++i) {
    const int parent = file.skeleton.nodes[i].parent;
    if (result.format == FileFormat::bvh) {
      const LocalTransform& posed = result.posed[i];
      result.rig.nodes.push_back({parent, posed.translation, posed.rotation});
    } else {
      const GltfPlace& place = found.posed.places[i];
      result.rig.nodes.push_back({parent, place.translation, place.rotation, place.scale});
    }
  }
  result.skeleton = std::move(file.skeleton);
  return result;
}

std::vector<Vec3d> joints_of(const Landmarks& person) {
  std::vector<Vec3d> joints;
  for_each_point(person, [&](const Vec3d& p) { joints.push_back(p); });
  return joints;
}

// Greatest distance (m) between corresponding joints of two persons.
double apart(const Landmarks& a, const Landmarks& b) {
  const std::vector<Vec3d> ours = joints_of(a);
  const std::vector<Vec3d> theirs = joints_of(b);
  if (ours.size() != theirs.size()) return 1e9;
  double most = 0.0;
  for (std::size_t i = 0; i < ours.size(); ++i) most = max(most, norm(ours[i] - theirs[i]));
  return most;
}

// Seats a measured person and their rig upright on their seat.
void seat_upright(CharacterSpec& spec) {
  spec.landmarks = seated(*spec.landmarks, *spec.stature, *spec.seat);
  CharacterRig rig = *spec.rig;
  rig.rig.start = *spec.landmarks;
  spec.rig = std::make_shared<const CharacterRig>(std::move(rig));
}

// Checks a person's settings before the file is read.
Result<void> check_person(const CharacterSpec& spec) {
  SHG_TRY(check_range("stature", spec.stature, kStatureMin, kStatureMax, "m"));
  SHG_TRY(check_range("seat", spec.seat, kSeatMin, kSeatMax, "m"));
  return is_robot(spec) ? check_robot_options(spec) : Result<void>{};
}

}  // namespace

bool is_complete(const CharacterSpec& spec) {
  return spec.landmarks || spec.urdf || is_built_in(spec);
}

bool is_robot(const CharacterSpec& spec) {
  const FormatInfo* file = character_format(spec.source);
  return spec.urdf || (!spec.landmarks && file != nullptr && file->robot);
}

bool is_built_in(const CharacterSpec& spec) {
  return std::find(kBuiltInCharacters.begin(), kBuiltInCharacters.end(), spec.source) !=
         kBuiltInCharacters.end();
}

Result<void> check_source(const CharacterSpec& spec) {
  if (is_complete(spec) || character_format(spec.source) != nullptr) return {};
  const std::vector<std::string> names(kBuiltInCharacters.begin(), kBuiltInCharacters.end());
  return fail(ErrorCode::invalid_argument,
              say("unknown_character", unknown_name("character", spec.source, names),
                  format_endings([](const FormatInfo& info) { return info.person || info.robot; })),
              "character");
}

Result<void> measure_character(CharacterSpec& spec, const std::filesystem::path& folder) {
  SHG_TRY(check_person(spec));
  if (is_complete(spec)) return {};
  SHG_TRY(check_source(spec));
  const std::filesystem::path path = folder / to_path(spec.source);
  SHG_TRY_ASSIGN(std::string bytes, read_character_bytes(path));
  spec.source = path.filename().string();
  return load_character(std::move(bytes), spec, path.parent_path());
}

Result<void> load_nodes(std::string_view nodes, CharacterSpec& spec) {
  SHG_TRY_ASSIGN(NodesFile file, glb_of_nodes(nodes, spec.source));
  if (file.posed && !spec.animation && !spec.frame) {
    spec.animation = kPosedNodes;
    spec.frame = 0;
  }
  return load_character(std::move(file.bytes), spec);
}

Result<void> load_character(std::string bytes, CharacterSpec& spec,
                            const std::optional<std::filesystem::path>& folder) {
  SHG_TRY(check_person(spec));
  SHG_TRY(check_source(spec));
  SHG_TRY(check_file_kind(bytes, spec.source));
  if (is_robot(spec)) return load_robot(bytes, spec, folder);
  SHG_TRY_ASSIGN(CharacterFile file, parse_character(std::move(bytes), spec));
  SHG_TRY_ASSIGN(PersonStart found, find_person(file, spec));
  const std::vector<Transformd> world = world_transforms(file.skeleton, found.measured.clip(), 0);
  list_bones(
      found.map, [&](std::size_t node) { return file.skeleton.nodes[node].name; }, spec);
  MeasuredPerson& start = found.start;
  if (spec.heels) {
    SHG_TRY(find_toes(world, found.map, found.person, spec.source, start));
  }
  spec.stature = found.person.stature;
  spec.landmarks = found.eased ? at_ease(start.landmarks, *spec.stature) : start.landmarks;
  if (spec.seat && !found.sits) {
    spec.landmarks = seated(*spec.landmarks, *spec.stature, *spec.seat);
  }
  if (found.eased && !spec.seat && spreads_arms(start.landmarks)) {
    const bool in_first_frame = file.motion.frames > 0 && !spec.frame && !found.frame;
    start.doubts.push_back(say("arms_spread", in_first_frame ? say("arms_of_frame") : Message{}));
  }
  // the rest pose belongs to no animation
  if (found.frame && !(found.frame == kRestPose && spec.animation)) spec.frame = found.frame;
  spec.doubts = file.doubts;
  for (const auto* more : {&found.map.doubts, &start.doubts}) {
    spec.doubts.insert(spec.doubts.end(), more->begin(), more->end());
  }
  if (start.placement.mirrored()) {
    spec.doubts.push_back(say("mirrored_file"));
  }
  CharacterRig rig = make_rig(std::move(file), found, *spec.landmarks);
  rig.rig.twists = find_twist_bones(rig.skeleton, world, found.map);
  const std::vector<Transformd> posed = world_transforms(rig.skeleton, found.posed.clip(), 0);
  rig.rig.fingers = find_finger_bones(rig.skeleton, posed, found.map, rig.vrm_bones,
                                      rig.rig.placement.mirrored());
  rig.rig.at_ease = found.eased;
  spec.rig = std::make_shared<const CharacterRig>(std::move(rig));
  if (const Result<PosedBody> body = build_character(spec)) find_places(*body, spec);
  return {};
}

int rig_node(const CharacterSpec& spec, std::string_view body_node) {
  if (!spec.rig) return -1;
  if (body_node == "left_hand_grip") return spec.rig->rig.grips[0];
  if (body_node == "right_hand_grip") return spec.rig->rig.grips[1];
  for (const HumanoidBone bone : kHumanoidBones) {
    if (humanoid_bone_name(bone) == body_node) return spec.rig->rig.bones[bone];
  }
  return -1;
}

Result<void> attach_rig(CharacterSpec& spec, const CharacterSpec& measured) {
  constexpr double kSame = 1e-6;  // m
  if (!spec.landmarks || !measured.rig || apart(*spec.landmarks, *measured.landmarks) > kSame) {
    return fail(ErrorCode::invalid_argument, say("other_person", spec.source), measured.source);
  }
  spec.rig = measured.rig;
  return {};
}

Result<void> attach_file(CharacterSpec& spec, const std::filesystem::path& path) {
  struct Try {
    std::optional<double> stature;
    std::optional<int> frame;
  };
  // a result holds the stature whether it was given or measured
  std::vector<Try> tries{{std::nullopt, spec.frame}, {spec.stature, spec.frame}};
  // older results have frame 0 for glTF's rest pose, and no frame for frame 0 of a motion
  if (spec.frame == 0 && !spec.animation) tries.push_back({std::nullopt, std::nullopt});
  if (!spec.frame) tries.insert(tries.end(), {{std::nullopt, 0}, {spec.stature, 0}});
  std::optional<Error> first;
  for (const auto& [stature, frame] : tries) {
    CharacterSpec fresh{.source = path.string(),
                        .stature = stature,
                        .frame = frame,
                        .animation = spec.animation,
                        .seat = spec.seat,
                        .heels = spec.heels,
                        .map = spec.map};
    const Result<void> measured = measure_character(fresh, {});
    Result<void> attached = measured ? attach_rig(spec, fresh) : measured;
    if (!attached && measured && spec.seat && frame) {
      // in older results a person who sits in the frame sits upright nevertheless
      seat_upright(fresh);
      attached = attach_rig(spec, fresh);
    }
    if (attached) return attached;
    if (!first) first = attached.error();
  }
  return tl::unexpected(*first);
}

Result<Character> open_character(CharacterSpec spec, const std::filesystem::path& folder) {
  SHG_TRY(measure_character(spec, folder));
  SHG_TRY_ASSIGN(PosedBody body, build_character(spec));
  return Character{std::move(body), std::move(spec)};
}

Result<PosedBody> build_character(const CharacterSpec& spec, Side base, bool on_both) {
  if (spec.urdf) return build_robot_character(spec);
  SHG_TRY(check_range("stature", spec.stature, kStatureMin, kStatureMax, "m"));
  SHG_TRY(check_range("mass", spec.mass, kMassMin, kMassMax, "kg"));
  SHG_TRY(check_range("seat", spec.seat, kSeatMin, kSeatMax, "m"));
  const double stature = spec.stature.value_or(mean_stature(spec.sex));
  const double of_limbs = spec.landmarks ? stature_of_limbs(*spec.landmarks, stature) : stature;
  const double mass = spec.mass.value_or(default_mass(of_limbs, spec.sex));
  BodyExtent extent = spec.extent.value_or(BodyExtent::human);
  if (!spec.landmarks && spec.source != "human") {
    extent = spec.source == "half_body" ? BodyExtent::half : BodyExtent::full;
  }
  if (spec.seat && extent == BodyExtent::half) {
    return fail(ErrorCode::invalid_argument, say("seat_of_one_side"), "character");
  }
  SHG_TRY(check_heels(spec, extent));
  const HumanSettings settings{.name = spec.source,
                               .extent = extent,
                               .stature = stature,
                               .mass = mass,
                               .sex = spec.sex,
                               .base = base,
                               .on_both = on_both,
                               .sits = spec.seat.has_value(),
                               .heels = spec.heels};
  if (spec.landmarks) {
    return placed_body(spec, build_human(*spec.landmarks, settings, spec.doubts));
  }
  if (spec.seat) {
    return build_human(seated(standing_landmarks(stature, kStandingToeOut), stature, *spec.seat),
                       settings);
  }
  const BodyBuild person{stature, mass, spec.sex, base, spec.heels};
  if (spec.source == "half_body") return half_body(person);
  return spec.source == "human" ? human_body(person) : full_body(person);
}

}  // namespace shigusa
