// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/core/names.hpp>
#include <shigusa/io/bvh.hpp>
#include <shigusa/io/gltf.hpp>
#include <shigusa/io/urdf.hpp>
#include <shigusa/project/character.hpp>
#include <shigusa/rollout/settled_posture.hpp>

namespace shigusa {
namespace {

constexpr std::array<std::string_view, 3> kBuiltIn{"half_body", "full_body", "human"};
constexpr double kStatureMin = 0.5;  // m
constexpr double kStatureMax = 2.5;
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
  bool posture = true;              // a frame is how a person stood, and not how they were modelled
};

Result<CharacterFile> read_character(const std::filesystem::path& path) {
  if (file_kind(path.string()) == FileKind::gltf) {
    Result<GltfCharacter> file = read_gltf(path);
    if (!file) return tl::unexpected(file.error());
    return CharacterFile{std::move(file->rest), std::move(file->humanoid), std::move(file->doubts),
                         false};
  }
  Result<SkeletonMotion> file = read_bvh(path);
  if (!file) return tl::unexpected(file.error());
  return CharacterFile{std::move(*file), {}, {}};
}

// The arms as those of a person who stands at ease, in their own lengths: a T is how characters
// are modelled, and nobody reaches from it. Exactly there two axes of a shoulder are one.
Landmarks with_hanging_arms(Landmarks person, double stature) {
  const Landmarks at_ease = standing_landmarks(stature, 0.0);
  const auto hang = [](Landmarks::Arm& arm, const Landmarks::Arm& like) {
    const auto along = [](const Vec3d& way, const Vec3d& length) {
      return normalized(way) * norm(length);
    };
    const Vec3d elbow = arm.shoulder + along(like.elbow - like.shoulder, arm.elbow - arm.shoulder);
    const Vec3d wrist = elbow + along(like.wrist - like.elbow, arm.wrist - arm.elbow);
    const Vec3d tip = wrist + along(like.fingertip - like.wrist, arm.fingertip - arm.wrist);
    arm = {arm.shoulder, elbow, wrist, tip};
  };
  hang(person.left_arm, at_ease.left_arm);
  hang(person.right_arm, at_ease.right_arm);
  return person;
}

struct ReadRobot {
  Robot robot;
  HumanoidMap map;
};

Result<ReadRobot> read_robot(std::string_view urdf, const std::string& name) {
  Result<Robot> robot = parse_urdf(urdf, name);
  if (!robot) return tl::unexpected(robot.error());
  robot->name = name;
  Result<HumanoidMap> map = find_humanoid(*robot);
  if (!map) {
    return fail(map.error().code, "no humanoid robot: " + map.error().to_string(), name);
  }
  return ReadRobot{std::move(*robot), std::move(*map)};
}

void tell_bones(const HumanoidMap& map, const auto& name_of, CharacterSpec& spec) {
  for (int b = 0; b < kHumanoidBoneCount; ++b) {
    const auto bone = static_cast<HumanoidBone>(b);
    if (map[bone] < 0) continue;
    spec.humanoid.emplace_back(humanoid_bone_name(bone),
                               name_of(static_cast<std::size_t>(map[bone])));
  }
}

Result<void> check_robot_options(const CharacterSpec& spec) {
  const struct {
    const char* what;
    bool given;
  } persons[] = {{"stature", spec.stature.has_value()},
                 {"mass", spec.mass.has_value()},
                 {"extent", spec.extent != BodyExtent::full},
                 {"frame", spec.frame != 0}};
  for (const auto& option : persons) {
    if (!option.given) continue;
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} is of a person, and {} is a robot, which has its own: leave it out",
                            option.what, spec.source),
                "character");
  }
  return {};
}

Result<void> read_robot_file(CharacterSpec& spec, const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  Result<std::string> text = read_urdf(path);
  if (!text) return tl::unexpected(text.error());
  const Result<ReadRobot> read = read_robot(*text, name);
  if (!read) return tl::unexpected(read.error());
  tell_bones(
      read->map, [&](std::size_t link) { return read->robot.links[link].name; }, spec);
  spec.source = name;
  spec.urdf = std::move(*text);
  return {};
}

Result<BodyModel> build_robot_character(const CharacterSpec& spec) {
  const Result<ReadRobot> read = read_robot(*spec.urdf, spec.source);
  if (!read) return tl::unexpected(read.error());
  const Result<BodyModel> body = build_robot(read->robot, read->map);
  if (!body) return fail(body.error().code, body.error().to_string(), spec.source);
  BodyDefinition standing = body->definition();
  standing.start = settled_posture(*body, standing.doubts);
  return BodyModel(std::move(standing));
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
  if (is_robot(spec)) {
    if (const auto ok = check_robot_options(spec); !ok) return ok;
  }
  if (is_complete(spec)) return {};
  if (const auto ok = check_source(spec); !ok) return ok;
  const std::filesystem::path path = folder / spec.source;
  if (is_robot(spec)) return read_robot_file(spec, path);
  const std::string name = path.filename().string();
  const Result<CharacterFile> file = read_character(path);
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
  const Result<HumanoidMap> map = find_humanoid(skeleton, world, file->given);
  if (!map) return fail(map.error().code, map.error().to_string(), name);
  const Result<MeasuredPerson> person =
      measure_person(skeleton, world, *map, {.stature = spec.stature});
  if (!person) return fail(person.error().code, person.error().to_string(), name);
  tell_bones(
      *map, [&](std::size_t node) { return skeleton.nodes[node].name; }, spec);
  spec.source = name;
  spec.stature = person->stature;
  spec.landmarks =
      file->posture ? person->landmarks : with_hanging_arms(person->landmarks, person->stature);
  spec.doubts = file->doubts;
  for (const auto* more : {&map->doubts, &person->doubts}) {
    spec.doubts.insert(spec.doubts.end(), more->begin(), more->end());
  }
  return {};
}

Result<BodyModel> build_character(const CharacterSpec& spec) {
  if (spec.urdf) return build_robot_character(spec);
  for (const auto& checked : {check_range("stature", spec.stature, kStatureMin, kStatureMax, "m"),
                              check_range("mass", spec.mass, kMassMin, kMassMax, "kg")}) {
    if (!checked) return tl::unexpected(checked.error());
  }
  const double stature = spec.stature.value_or(segment_table(spec.sex).mean_stature);
  const double mass = spec.mass.value_or(default_mass(stature, spec.sex));
  if (spec.landmarks) {
    return build_human(*spec.landmarks, {spec.source, spec.extent, stature, mass, spec.sex},
                       spec.doubts);
  }
  const Stature person{stature, mass, spec.sex};
  if (spec.source == "half_body") return half_body(person);
  return spec.source == "human" ? human_body(person) : full_body(person);
}

}  // namespace shigusa
