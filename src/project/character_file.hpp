// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/project/character.hpp>

namespace shigusa {

// The ending of a file's name in lower case: ".bvh".
[[nodiscard]] std::string file_ending(const std::string& name);

// The error of an animation that is asked for in a BVH file.
[[nodiscard]] tl::unexpected<Error> holds_one_motion(const std::string& name);

enum class FileKind { none, bvh, gltf, urdf };

// By the name's ending, in any case.
[[nodiscard]] FileKind file_kind(const std::string& name);

// The whole of a character's file, of any kind but `none`.
[[nodiscard]] Result<std::string> read_character_bytes(const std::filesystem::path& path);

// A person's BVH or glTF file.
struct CharacterFile {
  SkeletonMotion rest;                 // what the person is measured in: of BVH the motion itself
  SkeletonMotion motion;               // of BVH, or an animation of glTF; no frames: there is none
  HumanoidMap given;                   // by the file itself
  std::vector<std::string> doubts;     // of reading
  CharacterRig rig;                    // its format, and what that alone has
  std::vector<GltfPlace> posed;        // (nodes) of glTF, in the motion's frame or at rest
  std::vector<SkinVertex> skin;        // of glTF, at rest …
  std::vector<SkinVertex> posed_skin;  // … and in the motion's frame
};

// Parses the bytes of such a file. `animation`: of glTF, its name or its index, and the frame of it
// that the person is posed in; without one the file's rest pose is all.
[[nodiscard]] Result<CharacterFile> parse_character(std::string bytes, const std::string& name,
                                                    const std::optional<std::string>& animation,
                                                    int frame);

}  // namespace shigusa
