// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <shigusa/character.hpp>
#include <shigusa/formats.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/gltf.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// A character's own skeleton, for motions to leave on it.
struct CharacterRig {
  std::filesystem::path file;                // its name
  std::shared_ptr<const std::string> bytes;  // of glTF: all of it, for motions to be added to
  FileFormat format = FileFormat::bvh;       // bvh, glb or vrm, by what it holds
  Skeleton skeleton;                         // names; offsets in the file's units
  Rig rig;                                   // its nodes as the file has them in the frame measured
  std::vector<GltfPlace> places;             // of glTF: (nodes) at rest …
  std::vector<LocalTransform> posed;  // … and the skeleton in the frame measured, turned from rest
  BvhChannels channels;               // of BVH
  Vec3d ahead{0, 0, 1};               // of glTF: the way it faces at rest, its axes
  std::vector<int> file_node;         // of glTF: (nodes) indices in the file
  std::vector<std::pair<std::string, int>> vrm_bones;  // of VRM
  std::vector<std::string> animations;                 // of glTF: names of those that it has
  int frames = 0;                // of BVH's motion, or of the animation that the start is of
  bool stature_guessed = false;  // no unit makes a person of the file
  Message not_glb;  // why its glTF file cannot leave with animations; empty where it can
};

// The node of the character's file that a node of the body is ("right_foot", "right_hand_grip"), or
// -1 where it is none, or the spec has no rig.
[[nodiscard]] int rig_node(const CharacterSpec& spec, std::string_view body_node);

}  // namespace shigusa
