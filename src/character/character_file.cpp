// SPDX-License-Identifier: MIT
#include "character_file.hpp"

#include <fmt/format.h>

#include "core/check.hpp"
#include "core/say.hpp"
#include "files/file.hpp"
#include "formats/by_format.hpp"
#include "formats/fbx.hpp"
#include "formats/gltf_animation.hpp"
#include "formats/gltf_skin.hpp"
#include "formats/gltf_write.hpp"
#include "limb_ends.hpp"

namespace shigusa {
namespace {

static_assert(kCharacterMaxBytes == kGltfMaxBytes && kGltfMaxBytes >= kFbxMaxBytes &&
              kGltfMaxBytes >= kBvhMaxBytes);

void take(GltfCharacter&& file, CharacterFile& character) {
  character.skeleton = std::move(file.rest.skeleton);
  character.rest = {std::move(file.rest.clip.local), file.places};
  character.given = std::move(file.humanoid);
  character.doubts = std::move(file.doubts);
  character.rig.places = std::move(file.places);
  character.rig.format = file.vrm == VrmVersion::none ? FileFormat::glb : FileFormat::vrm;
  character.rig.file_node = std::move(file.file_node);
  character.rig.vrm_bones = std::move(file.vrm_bones);
}

// The animation that a spec requests, "" for the first; fails if a frame is requested of a file
// without animations.
Result<std::optional<std::string>> animation_of(const CharacterSpec& spec,
                                                const std::vector<std::string>& animations) {
  if (!spec.frame) return spec.animation;
  if (*spec.frame == kRestPose) {
    if (!spec.animation) return std::optional<std::string>{};
    return fail(ErrorCode::invalid_argument, say("rest_of_no_animation"), spec.source);
  }
  if (!spec.animation && animations.empty()) {
    return fail(ErrorCode::invalid_argument, say("no_animation_frame", *spec.frame), spec.source);
  }
  return spec.animation ? spec.animation : std::optional<std::string>("");
}

// Reads a glTF character. Nodes for hands and feet that the skeleton lacks are added to the bytes.
Result<void> parse_gltf_character(std::string& bytes, const CharacterSpec& spec,
                                  CharacterFile& character) {
  const std::string& name = spec.source;
  SHG_TRY_ASSIGN(GltfCharacter file, parse_gltf(bytes, name));
  Skin rest = read_gltf_skin(bytes, name, file, file.places);
  if (std::optional<EndedFile> ended = with_limb_ends(bytes, name, file, rest.vertices)) {
    bytes = std::move(ended->bytes);
    SHG_TRY_ASSIGN(file, parse_gltf(bytes, name));
    rest = read_gltf_skin(bytes, name, file, file.places);
    rest.doubts.insert(rest.doubts.end(), ended->doubts.begin(), ended->doubts.end());
  }
  character.skin = std::move(rest.vertices);
  if (std::optional<GltfPose> bound = gltf_bind_pose(bytes, name, file)) {
    character.bound_skin = read_gltf_skin(bytes, name, file, bound->places).vertices;
    character.bound = FilePose{std::move(bound->local), std::move(bound->places)};
  }
  const auto animations = gltf_animation_names(bytes, name);
  if (animations) character.rig.animations = *animations;
  const auto animation = animation_of(spec, character.rig.animations);
  // a file with malformed further chunks that is used at rest is reported by check_animations_fit
  if (!animation) return tl::unexpected(animations ? animation.error() : animations.error());
  if (*animation) {
    SHG_TRY_ASSIGN(GltfMotion moving,
                   parse_gltf_animation(
                       bytes, name,
                       {.animation = **animation, .posed = spec.frame.value_or(0), .gaps = true}));
    // empty if the animation has no such frame, which is reported when the person is measured
    if (!moving.posed.empty()) {
      character.posed_skin = read_gltf_skin(bytes, name, file, moving.posed).vertices;
    }
    take(std::move(moving.character), character);
    character.motion = std::move(moving.motion.clip);
    character.posed = std::move(moving.posed);
    character.gaps = std::move(moving.gaps);
    character.doubts = std::move(moving.doubts);
  } else {
    take(std::move(file), character);
  }
  character.doubts.insert(character.doubts.end(), rest.doubts.begin(), rest.doubts.end());
  if (const auto fits = check_animations_fit(bytes, name); !fits) {
    character.rig.not_glb = fits.error().message;
    character.doubts.push_back(say("not_as_glb", character.rig.not_glb));
  }
  return {};
}

}  // namespace

tl::unexpected<Error> holds_one_motion(const std::string& name) {
  return fail(ErrorCode::invalid_argument, say("one_motion"), name);
}

const FormatInfo* character_format(const std::string& name) {
  const std::optional<FileFormat> format = format_of_file(name);
  const FormatInfo* info = format ? &info_of(*format) : nullptr;
  return info != nullptr && (info->person || info->robot) ? info : nullptr;
}

Result<std::string> read_character_bytes(const std::filesystem::path& path) {
  const std::optional<FileFormat> format = format_of_file(path.string());
  SHG_CHECK(format, "a file that is read");
  return read_text_file(path, info_of(*format).max_bytes);
}

template <>
Result<void> read_person<FileFormat::bvh>(std::string bytes, const CharacterSpec& spec,
                                          CharacterFile& character) {
  if (spec.animation) return holds_one_motion(spec.source);
  SHG_TRY_ASSIGN(BvhFile file, parse_bvh_file(bytes, spec.source, BvhFaults::told));
  character.skeleton = std::move(file.motion.skeleton);
  character.motion = std::move(file.motion.clip);
  character.rig.channels = std::move(file.channels);
  character.doubts = std::move(file.doubts);
  character.unread_frames = std::move(file.unread_frames);
  for (const SkeletonNode& node : character.skeleton.nodes) {
    character.rest.local.push_back({node.offset, {}});
  }
  return {};
}

template <>
Result<void> read_person<FileFormat::glb>(std::string bytes, const CharacterSpec& spec,
                                          CharacterFile& character) {
  const auto parsed = parse_gltf_character(bytes, spec, character);
  character.rig.bytes = std::make_shared<const std::string>(std::move(bytes));
  return parsed;
}

template <>
Result<void> read_person<FileFormat::vrm>(std::string bytes, const CharacterSpec& spec,
                                          CharacterFile& character) {
  return read_person<FileFormat::glb>(std::move(bytes), spec, character);
}

// An FBX file is converted to the glTF file of its skeleton.
template <>
Result<void> read_person<FileFormat::fbx>(std::string bytes, const CharacterSpec& spec,
                                          CharacterFile& character) {
  SHG_TRY_ASSIGN(std::string glb, glb_of_fbx(bytes, spec.source));
  return read_person<FileFormat::glb>(std::move(glb), spec, character);
}

Result<CharacterFile> parse_character(std::string bytes, const CharacterSpec& spec) {
  static constexpr auto kReaders =
      by_format<Result<void>(std::string, const CharacterSpec&, CharacterFile&),
                &FormatInfo::person>([]<FileFormat format>() { return &read_person<format>; });
  const FormatInfo* info = character_format(spec.source);
  SHG_CHECK(info != nullptr && info->person, "a person's file");
  CharacterFile character;
  character.rig.file = spec.source;
  SHG_TRY(kReaders[static_cast<std::size_t>(info->format)](std::move(bytes), spec, character));
  return character;
}

}  // namespace shigusa
