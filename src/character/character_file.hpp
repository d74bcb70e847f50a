// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>

#include "body/skin.hpp"
#include "character/character_rig.hpp"
#include "formats/gltf_animation.hpp"
#include "measure/measure_person.hpp"

namespace shigusa {

// The error of an animation that is asked for in a BVH file.
[[nodiscard]] tl::unexpected<Error> holds_one_motion(const std::string& name);

// The format of a character's file by the name's ending, from the table; null where characters are
// read from no such file.
[[nodiscard]] const FormatInfo* character_format(const std::string& name);

// The whole of a file that is read, as far as its format allows.
[[nodiscard]] Result<std::string> read_character_bytes(const std::filesystem::path& path);

// One pose of a file's nodes.
struct FilePose {
  std::vector<LocalTransform> local;  // (nodes) turned from the rest pose
  std::vector<GltfPlace> places;      // (nodes) of glTF

  [[nodiscard]] SkeletonClip clip() const { return {.frames = 1, .local = local}; }
};

// A person's BVH, glTF or FBX file.
struct CharacterFile {
  Skeleton skeleton;
  FilePose rest;                       // of BVH that of the OFFSETs
  std::optional<FilePose> bound;       // of glTF: in which the mesh was bound, where it is another
  SkeletonClip motion;                 // of BVH, or an animation of glTF; no frames: there is none
  std::vector<int> unread_frames;      // of it, rising: those that are no postures
  std::vector<GltfGap> gaps;           // of it, of glTF: by node, where it is not known
  std::vector<GltfPlace> posed;        // (nodes) of glTF, in the motion's frame asked for
  HumanoidMap given;                   // by the file itself
  std::vector<Message> doubts;         // of reading
  CharacterRig rig;                    // its format, and what that alone has
  std::vector<SkinVertex> skin;        // of glTF, at rest,
  std::vector<SkinVertex> bound_skin;  // where it was bound,
  std::vector<SkinVertex> posed_skin;  // and in the frame asked for
};

// Parses the bytes of such a file. Of glTF with the animation that the spec asks for, by its name,
// its index or as the first for a frame alone.
[[nodiscard]] Result<CharacterFile> parse_character(std::string bytes, const CharacterSpec& spec);

// The reader of one format; each that people are read from (FormatInfo::person) has one.
template <FileFormat format>
[[nodiscard]] Result<void> read_person(std::string bytes, const CharacterSpec& spec,
                                       CharacterFile& character);

// A person in a file, measured, and the posture that they start from.
struct PersonStart {
  HumanoidMap map;
  FilePose measured;      // the pose that the person is measured in …
  MeasuredPerson person;  // … and what was measured
  FilePose posed;         // the pose that the motion starts from, as the file has it …
  MeasuredPerson start;   // … and the person in it; with all doubts
  bool eased = false;     // they stand at ease from there
  bool sits = false;      // they sit as the file has it
  std::optional<int>
      frame{};  // that was found, where none was asked for; kRestPose of the rest pose
};

// Finds and measures the person of a file in the pose that the spec asks for. Frames in which a
// node that carries the person is not known are added to the unread ones.
[[nodiscard]] Result<PersonStart> find_person(CharacterFile& file, const CharacterSpec& spec);

}  // namespace shigusa
