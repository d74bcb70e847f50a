// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/body/at_ease.hpp>
#include <shigusa/core/names.hpp>
#include <shigusa/io/file.hpp>
#include <shigusa/io/gltf_write.hpp>
#include <shigusa/project/character.hpp>

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

enum class FileKind { none, bvh, gltf, urdf };

// By the name's ending, in any case.
FileKind file_kind(const std::string& source) {
  std::string ending = std::filesystem::path(source).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".bvh") return FileKind::bvh;
  if (ending == ".urdf") return FileKind::urdf;
  for (const char* each : {".glb", ".gltf", ".vrm"}) {
    if (ending == each) return FileKind::gltf;
  }
  return FileKind::none;
}

// A character as its file has it; glTF tells one frame, the rest pose.
struct CharacterFile {
  SkeletonMotion motion;
  HumanoidMap given;                // by the file itself
  std::vector<std::string> doubts;  // of reading
  CharacterRig rig;                 // its format, and what that alone has
  std::vector<GltfPlace> places;    // (nodes) of glTF
};

Result<CharacterFile> read_character(const std::filesystem::path& path) {
  CharacterFile character;
  character.rig.file = path;
  if (file_kind(path.string()) == FileKind::gltf) {
    const std::string name = path.filename().string();
    const Result<std::string> bytes = read_text_file(path, kGltfMaxBytes);
    if (!bytes) return tl::unexpected(bytes.error());
    Result<GltfCharacter> file = parse_gltf(*bytes, name);
    if (!file) return tl::unexpected(file.error());
    if (const auto fits = check_animations_fit(*bytes, name); !fits) {
      character.rig.not_glb = fits.error().message;
    }
    character.motion = std::move(file->rest);
    character.given = std::move(file->humanoid);
    character.doubts = std::move(file->doubts);
    if (!character.rig.not_glb.empty()) {
      character.doubts.push_back("motions cannot leave as GLB: " + character.rig.not_glb);
    }
    character.places = std::move(file->places);
    character.rig.format =
        file->vrm == VrmVersion::none ? CharacterFormat::gltf : CharacterFormat::vrm;
    character.rig.file_node = std::move(file->file_node);
    character.rig.vrm_bones = std::move(file->vrm_bones);
    return character;
  }
  Result<BvhFile> file = read_bvh_file(path);
  if (!file) return tl::unexpected(file.error());
  character.motion = std::move(file->motion);
  character.rig.channels = std::move(file->channels);
  return character;
}

// What ties the file's nodes to the person who was measured from them, in that frame.
CharacterRig make_rig(CharacterFile&& file, int frame, const HumanoidMap& map,
                      const MeasuredPerson& person, const Landmarks& start) {
  CharacterRig result = std::move(file.rig);
  result.rig = {{}, map, person.grip_nodes, person.placement, person.landmarks, start};
  const auto& [skeleton, clip] = file.motion;
  for (std::size_t i = 0; i < skeleton.nodes.size(); ++i) {
    const int parent = skeleton.nodes[i].parent;
    if (result.format == CharacterFormat::bvh) {
      const LocalTransform& local = clip.frame(skeleton, frame)[i];
      result.rig.nodes.push_back({parent, local.translation, local.rotation});
    } else {
      const GltfPlace& place = file.places[i];
      result.rig.nodes.push_back({parent, place.translation, place.rotation, place.scale});
    }
  }
  result.skeleton = std::move(file.motion.skeleton);
  return result;
}

std::vector<Vec3d> joints_of(const Landmarks& person) {
  std::vector<Vec3d> joints = person.spine;
  for_each_landmark(person, [&](const char*, const Vec3d& p) { joints.push_back(p); });
  for_each_further_landmark(person, [&](const char*, const std::optional<Vec3d>& p) {
    if (p) joints.push_back(*p);
  });
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
  if (const auto ok = check_range("stature", spec.stature, kStatureMin, kStatureMax, "m"); !ok) {
    return ok;
  }
  if (const auto ok = check_range("seat", spec.seat, kSeatMin, kSeatMax, "m"); !ok) return ok;
  if (is_robot(spec)) {
    if (const auto ok = check_robot_options(spec); !ok) return ok;
  }
  if (is_complete(spec)) return {};
  if (const auto ok = check_source(spec); !ok) return ok;
  const std::filesystem::path path = folder / spec.source;
  if (is_robot(spec)) return read_robot_file(spec, path);
  const std::string name = path.filename().string();
  Result<CharacterFile> file = read_character(path);
  if (!file) return tl::unexpected(file.error());
  const Skeleton& skeleton = file->motion.skeleton;
  const SkeletonClip& clip = file->motion.clip;
  if (spec.frame < 0 || spec.frame >= clip.frames) {
    const std::string has =
        clip.frames == 1 ? "only frame 0" : fmt::format("the frames 0 to {}", clip.frames - 1);
    return fail(ErrorCode::invalid_argument,
                fmt::format("frame {} does not exist; the file has {}", spec.frame, has), name);
  }
  const std::vector<Transformd> world = world_transforms(skeleton, clip, spec.frame);
  std::vector<std::string> nodes;
  for (const SkeletonNode& node : skeleton.nodes) nodes.push_back(node.name);
  const Result<HumanoidMap> asked = requested_bones(spec.map, nodes, name);
  if (!asked) return tl::unexpected(asked.error());
  const Result<HumanoidMap> map = find_humanoid(skeleton, world, file->given, *asked);
  if (!map) return fail(map.error().code, map.error().to_string(), name);
  const Result<MeasuredPerson> person =
      measure_person(skeleton, world, *map, {.stature = spec.stature});
  if (!person) return fail(person.error().code, person.error().to_string(), name);
  tell_bones(
      *map, [&](std::size_t node) { return skeleton.nodes[node].name; }, spec);
  spec.source = name;
  spec.stature = person->stature;
  const bool posture = file->rig.format == CharacterFormat::bvh;
  spec.landmarks = posture ? person->landmarks : at_ease(person->landmarks, person->stature);
  if (spec.seat) spec.landmarks = seated(*spec.landmarks, person->stature, *spec.seat);
  spec.doubts = file->doubts;
  for (const auto* more : {&map->doubts, &person->doubts}) {
    spec.doubts.insert(spec.doubts.end(), more->begin(), more->end());
  }
  if (person->placement.mirrored()) {
    spec.doubts.push_back(
        "files with the character's own skeleton keep the mirrored axes: goals are not where they "
        "stand in them");
  }
  spec.rig = make_rig(std::move(*file), spec.frame, *map, *person, *spec.landmarks);
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

Result<void> attach_file(CharacterSpec& spec, const std::filesystem::path& path) {
  constexpr double kSame = 1e-6;  // m
  // the stature stands in a result whether it was given or measured
  for (const std::optional<double>& stature : {std::optional<double>{}, spec.stature}) {
    CharacterSpec fresh{.source = path.string(),
                        .stature = stature,
                        .frame = spec.frame,
                        .seat = spec.seat,
                        .map = spec.map};
    if (const auto measured = measure_character(fresh, {}); !measured) {
      if (stature) return measured;
      continue;
    }
    if (!spec.landmarks || !fresh.rig || apart(*spec.landmarks, *fresh.landmarks) > kSame) continue;
    spec.rig = std::move(fresh.rig);
    return {};
  }
  return fail(
      ErrorCode::invalid_argument,
      fmt::format("is not the person of the result, {}, who may have been mirrored or changed "
                  "since",
                  spec.source),
      path.filename().string());
}

Result<BodyModel> build_character(const CharacterSpec& spec, Side base) {
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
  const HumanSettings settings{.name = spec.source,
                               .extent = extent,
                               .stature = stature,
                               .mass = mass,
                               .sex = spec.sex,
                               .base = base,
                               .sits = spec.seat.has_value()};
  if (spec.landmarks) {
    return placed_body(spec, build_human(*spec.landmarks, settings, spec.doubts));
  }
  if (spec.seat) {
    return build_human(seated(standing_landmarks(stature, kStandingToeOut), stature, *spec.seat),
                       settings);
  }
  const Stature person{stature, mass, spec.sex, base};
  if (spec.source == "half_body") return half_body(person);
  return spec.source == "human" ? human_body(person) : full_body(person);
}

}  // namespace shigusa
