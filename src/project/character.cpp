// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/body/at_ease.hpp>
#include <shigusa/core/names.hpp>
#include <shigusa/io/gltf_animation.hpp>
#include <shigusa/project/character.hpp>

#include "character_file.hpp"
#include "character_heels.hpp"
#include "character_places.hpp"
#include "character_robot.hpp"
#include "humanoid_request.hpp"
#include "landmarks_json.hpp"

namespace shigusa {
namespace {

constexpr std::array<std::string_view, 3> kBuiltIn{"half_body", "full_body", "human"};
constexpr double kStatureMin = 0.5;  // m
constexpr double kStatureMax = 2.5;
constexpr double kSeatMin = 0.1;  // m
constexpr double kSeatMax = 1.2;
constexpr double kMassMin = 2.0;  // kg
constexpr double kMassMax = 300.0;

Result<void> check_range(const char* what, const std::optional<double>& value, double low,
                         double high, const char* unit) {
  if (!value || (*value >= low && *value <= high)) return {};
  return fail(
      ErrorCode::invalid_argument,
      fmt::format("{} is {} {}; allowed are {:g} to {:g} {}", what, *value, unit, low, high, unit),
      "character");
}

// What ties the file's nodes to the person who was measured from them in that frame of the motion.
CharacterRig make_rig(CharacterFile&& file, const SkeletonClip& motion, int frame,
                      const HumanoidMap& map, const MeasuredPerson& person,
                      const Landmarks& start) {
  CharacterRig result = std::move(file.rig);
  result.rig = {{}, map, person.grip_nodes, person.placement, person.landmarks, start};
  const Skeleton& skeleton = file.rest.skeleton;
  const LocalTransform* posed = motion.frame(skeleton, frame);
  result.posed.assign(posed, posed + skeleton.nodes.size());
  for (std::size_t i = 0; i < skeleton.nodes.size(); ++i) {
    const int parent = skeleton.nodes[i].parent;
    if (result.format == CharacterFormat::bvh) {
      result.rig.nodes.push_back({parent, posed[i].translation, posed[i].rotation});
    } else {
      const GltfPlace& place = file.posed[i];
      result.rig.nodes.push_back({parent, place.translation, place.rotation, place.scale});
    }
  }
  result.skeleton = std::move(file.rest.skeleton);
  return result;
}

std::vector<Vec3d> joints_of(const Landmarks& person) {
  std::vector<Vec3d> joints;
  for_each_point(person, [&](const Vec3d& p) { joints.push_back(p); });
  return joints;
}

// The farthest that a joint of one person stands from the other's (m).
double apart(const Landmarks& a, const Landmarks& b) {
  const std::vector<Vec3d> ours = joints_of(a);
  const std::vector<Vec3d> theirs = joints_of(b);
  if (ours.size() != theirs.size()) return 1e9;
  double most = 0.0;
  for (std::size_t i = 0; i < ours.size(); ++i) most = max(most, norm(ours[i] - theirs[i]));
  return most;
}

// Moves the person up or down until the lower sole of somebody of that stature is on the floor.
void stand_on_floor(MeasuredPerson& measured, double stature) {
  Landmarks& person = measured.landmarks;
  double floor = 1e9;
  for (const Side side : {Side::left, Side::right}) {
    const Landmarks::Leg& leg = person.leg(side);
    const double by_joints = min(leg.ankle.y - StatureFractions::kAnkleHeight * stature, leg.toe.y);
    floor = min(floor, leg.sole ? (*leg.sole)[0].y : by_joints);
  }
  for_each_point(person, [&](Vec3d& p) { p.y -= floor; });
  measured.placement.origin += measured.placement.up * (floor / measured.placement.unit);
}

// The person in a frame of an animation, in the unit and with the stature that the rest pose told:
// what is measured along the bones of a bent trunk is another one.
Result<MeasuredPerson> measure_posed(const Skeleton& skeleton, const SkeletonClip& clip, int frame,
                                     const HumanoidMap& map, const MeasuredPerson& rest,
                                     std::span<const SkinVertex> skin) {
  const std::vector<Transformd> world = world_transforms(skeleton, clip, frame);
  const Result<MeasuredPerson> bent =
      measure_person(skeleton, world, map, {.stature = rest.stature, .skin = skin});
  if (!bent) return bent;
  const double along = rest.stature * rest.placement.unit / bent->placement.unit;
  Result<MeasuredPerson> posed =
      measure_person(skeleton, world, map, {.stature = along, .skin = skin});
  if (!posed) return posed;
  stand_on_floor(*posed, rest.stature);
  // limbs are straight at rest, and their mesh as it was made
  posed->landmarks.parts = rest.landmarks.parts;
  return posed;
}

// What is said of the person, before the file is read.
Result<void> check_person(const CharacterSpec& spec) {
  if (const auto ok = check_range("stature", spec.stature, kStatureMin, kStatureMax, "m"); !ok) {
    return ok;
  }
  if (const auto ok = check_range("seat", spec.seat, kSeatMin, kSeatMax, "m"); !ok) return ok;
  return is_robot(spec) ? check_robot_options(spec) : Result<void>{};
}

Result<void> check_frame(const SkeletonClip& clip, const CharacterSpec& spec) {
  if (spec.frame >= 0 && spec.frame < clip.frames) return {};
  const std::string has =
      clip.frames == 1 ? "only frame 0" : fmt::format("the frames 0 to {}", clip.frames - 1);
  return fail(ErrorCode::invalid_argument,
              fmt::format("frame {} does not exist; the file has {}", spec.frame, has),
              spec.source);
}

}  // namespace

bool is_complete(const CharacterSpec& spec) {
  return spec.landmarks || spec.urdf || is_built_in(spec);
}

bool is_robot(const CharacterSpec& spec) {
  return spec.urdf || (!spec.landmarks && file_kind(spec.source) == FileKind::urdf);
}

bool is_built_in(const CharacterSpec& spec) {
  return std::find(kBuiltIn.begin(), kBuiltIn.end(), spec.source) != kBuiltIn.end();
}

Result<void> check_source(const CharacterSpec& spec) {
  const bool file = file_kind(spec.source) != FileKind::none;
  if (is_complete(spec) || file) return {};
  const std::vector<std::string> names(kBuiltIn.begin(), kBuiltIn.end());
  return fail(ErrorCode::invalid_argument,
              unknown_name("character", spec.source, names) +
                  ", or a file that ends in .bvh, .glb, .gltf, .vrm or .urdf",
              "character");
}

Result<void> measure_character(CharacterSpec& spec, const std::filesystem::path& folder) {
  if (const auto ok = check_person(spec); !ok) return ok;
  if (is_complete(spec)) return {};
  if (const auto ok = check_source(spec); !ok) return ok;
  const std::filesystem::path path = folder / spec.source;
  Result<std::string> bytes = read_character_bytes(path);
  if (!bytes) return tl::unexpected(bytes.error());
  spec.source = path.filename().string();
  return load_character(std::move(*bytes), spec);
}

Result<void> load_character(std::string bytes, CharacterSpec& spec) {
  if (const auto ok = check_person(spec); !ok) return ok;
  if (const auto ok = check_source(spec); !ok) return ok;
  if (is_robot(spec)) return load_robot(bytes, spec);
  const std::string& name = spec.source;
  // a frame of a file that has animations is one of the first
  const bool still = file_kind(name) == FileKind::bvh || spec.frame == 0;
  const std::optional<std::string> animation =
      spec.animation || still ? spec.animation : std::optional<std::string>("");
  const bool implied = animation && !spec.animation;
  if (implied) {
    const auto names = gltf_animation_names(bytes, name);
    if (!names) return tl::unexpected(names.error());
    if (names->empty()) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("frame {} does not exist; the file has only its rest pose, frame 0",
                              spec.frame),
                  name);
    }
  }
  Result<CharacterFile> file = parse_character(std::move(bytes), name, animation, spec.frame);
  if (!file) return tl::unexpected(file.error());
  const SkeletonMotion& motion = animation ? file->motion : file->rest;
  if (const auto ok = check_frame(motion.clip, spec); !ok) return ok;
  // glTF is measured at rest, where no animation hides what its bones are
  const int measured = animation ? 0 : spec.frame;
  const Skeleton& skeleton = file->rest.skeleton;
  const std::vector<Transformd> world = world_transforms(skeleton, file->rest.clip, measured);
  std::vector<std::string> nodes;
  for (const SkeletonNode& node : skeleton.nodes) nodes.push_back(node.name);
  const Result<HumanoidMap> asked = requested_bones(spec.map, nodes, name, file->rig.file_node);
  if (!asked) return tl::unexpected(asked.error());
  const Result<HumanoidMap> map = find_humanoid(skeleton, world, file->given, *asked, file->skin);
  if (!map) return fail(map.error().code, map.error().to_string(), name);
  const Result<MeasuredPerson> person =
      measure_person(skeleton, world, *map, {.stature = spec.stature, .skin = file->skin});
  if (!person) return fail(person.error().code, person.error().to_string(), name);
  MeasuredPerson start = *person;
  if (animation) {
    Result<MeasuredPerson> posed =
        measure_posed(skeleton, motion.clip, spec.frame, *map, *person, file->posed_skin);
    if (!posed) return fail(posed.error().code, posed.error().to_string(), name);
    start = std::move(*posed);
  }
  tell_bones(
      *map, [&](std::size_t node) { return skeleton.nodes[node].name; }, spec);
  if (spec.heels) {
    if (const auto ok = find_toes(world, *map, *person, name, start); !ok) return ok;
  }
  spec.stature = person->stature;
  const bool rests = !animation && file->rig.format != CharacterFormat::bvh;
  spec.landmarks = rests ? at_ease(start.landmarks, person->stature) : start.landmarks;
  if (spec.seat) spec.landmarks = seated(*spec.landmarks, person->stature, *spec.seat);
  spec.doubts = file->doubts;
  const std::vector<std::string>* found[] = {&map->doubts, &start.doubts};
  for (const auto* more : found) {
    spec.doubts.insert(spec.doubts.end(), more->begin(), more->end());
  }
  if (start.placement.mirrored()) {
    spec.doubts.push_back(
        "files with the character's own skeleton keep the mirrored axes: goals are not where they "
        "stand in them");
  }
  const SkeletonClip clip = std::move(animation ? file->motion.clip : file->rest.clip);
  spec.rig = make_rig(std::move(*file), clip, spec.frame, *map, start, *spec.landmarks);
  spec.rig->ahead = person->placement.ahead;
  spec.rig->rig.twists = find_twist_bones(spec.rig->skeleton, world, *map);
  if (const Result<BodyModel> body = build_character(spec)) find_places(*body, spec);
  return {};
}

int rig_node(const CharacterSpec& spec, std::string_view body_node) {
  if (!spec.rig) return -1;
  if (body_node == "left_hand_grip") return spec.rig->rig.grips[0];
  if (body_node == "right_hand_grip") return spec.rig->rig.grips[1];
  for (int b = 0; b < kHumanoidBoneCount; ++b) {
    const auto bone = static_cast<HumanoidBone>(b);
    if (humanoid_bone_name(bone) == body_node) return spec.rig->rig.bones[bone];
  }
  return -1;
}

Result<void> attach_rig(CharacterSpec& spec, const CharacterSpec& measured) {
  constexpr double kSame = 1e-6;  // m
  if (!spec.landmarks || !measured.rig || apart(*spec.landmarks, *measured.landmarks) > kSame) {
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("is not the person of the result, {}, who may have been mirrored or changed "
                    "since",
                    spec.source),
        measured.source);
  }
  spec.rig = measured.rig;
  return {};
}

Result<void> attach_file(CharacterSpec& spec, const std::filesystem::path& path) {
  Result<void> attached;
  // the stature stands in a result whether it was given or measured
  for (const std::optional<double>& stature : {std::optional<double>{}, spec.stature}) {
    CharacterSpec fresh{.source = path.string(),
                        .stature = stature,
                        .frame = spec.frame,
                        .animation = spec.animation,
                        .seat = spec.seat,
                        .heels = spec.heels,
                        .map = spec.map};
    if (const auto measured = measure_character(fresh, {}); !measured) {
      if (stature) return measured;
      continue;
    }
    attached = attach_rig(spec, fresh);
    if (attached) return attached;
  }
  return fail(attached.error().code, attached.error().message, path.filename().string());
}

Result<BodyModel> build_character(const CharacterSpec& spec, Side base, bool on_both) {
  if (spec.urdf) return build_robot_character(spec);
  for (const auto& checked : {check_range("stature", spec.stature, kStatureMin, kStatureMax, "m"),
                              check_range("mass", spec.mass, kMassMin, kMassMax, "kg"),
                              check_range("seat", spec.seat, kSeatMin, kSeatMax, "m")}) {
    if (!checked) return tl::unexpected(checked.error());
  }
  const double stature = spec.stature.value_or(segment_table(spec.sex).mean_stature);
  const double mass = spec.mass.value_or(default_mass(stature, spec.sex));
  BodyExtent extent = spec.extent.value_or(BodyExtent::human);
  if (!spec.landmarks && spec.source != "human") {
    extent = spec.source == "half_body" ? BodyExtent::half : BodyExtent::full;
  }
  if (spec.seat && extent == BodyExtent::half) {
    return fail(ErrorCode::invalid_argument, "a seat is not for a body of one side", "character");
  }
  if (const auto ok = check_heels(spec, extent); !ok) return tl::unexpected(ok.error());
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
  const Stature person{stature, mass, spec.sex, base, spec.heels};
  if (spec.source == "half_body") return half_body(person);
  return spec.source == "human" ? human_body(person) : full_body(person);
}

}  // namespace shigusa
