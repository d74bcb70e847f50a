// SPDX-License-Identifier: MIT
#include "character_file.hpp"

#include <shigusa/io/file.hpp>
#include <shigusa/io/gltf_animation.hpp>
#include <shigusa/io/gltf_skin.hpp>
#include <shigusa/io/gltf_write.hpp>
#include <shigusa/io/urdf.hpp>

namespace shigusa {
namespace {

// The mesh at rest, and where the nodes of an animation's frame take it; doubts about it.
std::vector<std::string> take_skin(const std::string& bytes, const std::string& name,
                                   const GltfCharacter& file, std::span<const GltfPlace> posed,
                                   CharacterFile& character) {
  Skin rest = read_gltf_skin(bytes, name, file, file.places);
  character.skin = std::move(rest.vertices);
  if (!posed.empty()) character.posed_skin = read_gltf_skin(bytes, name, file, posed).vertices;
  return std::move(rest.doubts);
}

void take(GltfCharacter&& file, CharacterFile& character) {
  character.rest = std::move(file.rest);
  character.given = std::move(file.humanoid);
  character.doubts = std::move(file.doubts);
  character.rig.places = std::move(file.places);
  character.rig.format =
      file.vrm == VrmVersion::none ? CharacterFormat::gltf : CharacterFormat::vrm;
  character.rig.file_node = std::move(file.file_node);
  character.rig.vrm_bones = std::move(file.vrm_bones);
}

Result<void> parse_gltf_character(const std::string& bytes, const std::string& name,
                                  const std::optional<std::string>& animation, int frame,
                                  CharacterFile& character) {
  std::vector<std::string> skin_doubts;
  if (animation) {
    Result<GltfMotion> file =
        parse_gltf_animation(bytes, name, {.animation = *animation, .posed = frame});
    if (!file) return tl::unexpected(file.error());
    skin_doubts = take_skin(bytes, name, file->character, file->posed, character);
    take(std::move(file->character), character);
    character.motion = std::move(file->motion);
    character.posed = std::move(file->posed);
    character.doubts = std::move(file->doubts);
  } else {
    Result<GltfCharacter> file = parse_gltf(bytes, name);
    if (!file) return tl::unexpected(file.error());
    skin_doubts = take_skin(bytes, name, *file, {}, character);
    take(std::move(*file), character);
    character.posed = character.rig.places;
  }
  character.doubts.insert(character.doubts.end(), skin_doubts.begin(), skin_doubts.end());
  // of a file whose further chunks are wrong, check_animations_fit tells
  if (auto names = gltf_animation_names(bytes, name)) character.rig.animations = std::move(*names);
  if (const auto fits = check_animations_fit(bytes, name); !fits) {
    character.rig.not_glb = fits.error().message;
    character.doubts.push_back("motions cannot leave as GLB: " + character.rig.not_glb);
  }
  return {};
}

}  // namespace

std::string file_ending(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

tl::unexpected<Error> holds_one_motion(const std::string& name) {
  return fail(ErrorCode::invalid_argument,
              "holds one motion without a name: leave the animation out", name);
}

FileKind file_kind(const std::string& name) {
  const std::string ending = file_ending(name);
  if (ending == ".bvh") return FileKind::bvh;
  if (ending == ".urdf") return FileKind::urdf;
  for (const char* each : {".glb", ".gltf", ".vrm"}) {
    if (ending == each) return FileKind::gltf;
  }
  return FileKind::none;
}

Result<std::string> read_character_bytes(const std::filesystem::path& path) {
  const FileKind kind = file_kind(path.string());
  return read_text_file(path, kind == FileKind::bvh    ? kBvhMaxBytes
                              : kind == FileKind::urdf ? kUrdfMaxBytes
                                                       : kGltfMaxBytes);
}

Result<CharacterFile> parse_character(std::string bytes, const std::string& name,
                                      const std::optional<std::string>& animation, int frame) {
  CharacterFile character;
  character.rig.file = name;
  if (file_kind(name) == FileKind::gltf) {
    const auto parsed = parse_gltf_character(bytes, name, animation, frame, character);
    if (!parsed) return tl::unexpected(parsed.error());
    character.rig.bytes = std::make_shared<const std::string>(std::move(bytes));
    return character;
  }
  if (animation) return holds_one_motion(name);
  Result<BvhFile> file = parse_bvh_file(bytes, name);
  if (!file) return tl::unexpected(file.error());
  character.rest = std::move(file->motion);
  character.rig.channels = std::move(file->channels);
  return character;
}

}  // namespace shigusa
