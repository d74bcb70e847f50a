// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>

#include "body/skin.hpp"
#include "character/character_rig.hpp"
#include "formats/gltf_animation.hpp"
#include "measure/measure_person.hpp"

namespace shigusa {

// Error for an animation requested from a BVH file.
[[nodiscard]] tl::unexpected<Error> holds_one_motion(const std::string& name);

// Format of a character's file, from its name's ending; null if characters are not read from such
// files.
[[nodiscard]] const FormatInfo* character_format(const std::string& name);

// Reads a whole file, up to its format's size limit.
[[nodiscard]] Result<std::string> read_character_bytes(const std::filesystem::path& path);

// One pose of a file's nodes.
struct FilePose {
  std::vector<LocalTransform> local;  // (nodes) rotations from the rest pose
  std::vector<GltfPlace> places;      // (nodes) of glTF

  [[nodiscard]] SkeletonClip clip() const { return {.frames = 1, .local = local}; }
};

// Contents of a person's BVH, glTF or FBX file.
struct CharacterFile {
  Skeleton skeleton;
  FilePose rest;                       // for BVH that of the OFFSETs
  std::optional<FilePose> bound;       // glTF: pose in which the mesh was bound, if it differs
  SkeletonClip motion;                 // of BVH, or a glTF animation; without frames: none
  std::vector<int> unread_frames;      // its frames that are no postures, ascending
  std::vector<GltfGap> gaps;           // glTF: its gaps by node
  std::vector<GltfPlace> posed;        // glTF: (nodes) in the requested frame of the motion
  HumanoidMap given;                   // bone map given by the file itself
  std::vector<Message> doubts;         // doubts of the reader
  CharacterRig rig;                    // its format, and the data that only that format has
  std::vector<SkinVertex> skin;        // glTF: mesh at rest
  std::vector<SkinVertex> bound_skin;  // mesh in the bind pose
  std::vector<SkinVertex> posed_skin;  // mesh in the requested frame
};

// Parses the bytes of such a file. For glTF it includes the animation that the spec requests by
// name or index, or the first one if only a frame is requested.
[[nodiscard]] Result<CharacterFile> parse_character(std::string bytes, const CharacterSpec& spec);

// Reader of one format; each format with FormatInfo::person has a specialisation.
template <FileFormat format>
[[nodiscard]] Result<void> read_person(std::string bytes, const CharacterSpec& spec,
                                       CharacterFile& character);

// The person measured in a file, and their start posture.
struct PersonStart {
  HumanoidMap map;
  FilePose measured;      // pose in which the person was measured
  MeasuredPerson person;  // result of that measurement
  FilePose posed;         // pose of the file that the motion starts from
  MeasuredPerson start;   // the person in that pose; with all doubts
  bool eased = false;     // whether they start at ease from that pose
  bool sits = false;      // whether they sit as in the file
  std::optional<int>
      frame{};  // frame that was found, if none was requested; kRestPose for the rest pose
};

// Finds and measures the person of a file in the requested pose. Frames in which a node that
// carries the person is unknown are added to the unread ones.
[[nodiscard]] Result<PersonStart> find_person(CharacterFile& file, const CharacterSpec& spec);

}  // namespace shigusa
